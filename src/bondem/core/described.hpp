// Descriptions of tables, the structs of arrays and numbers that passes take. `_core.py` reads names, types, shapes
// and offsets of their fields from the library, and compares them with the tables of Python.
#pragma once
#include "array.hpp"
#include "laws/rotations.hpp"
#include "table_names.hpp"

namespace bondem {

struct FieldDescription {
    const char *name, *type, *shape;  // shape: lengths of the axes, such as "n+1 3"; equal letters are equal in a call
    Index offset;
};
struct TableDescription {
    const char *name;
    Index size;
    const FieldDescription *fields;
    Index count;
};

template <class T> struct TypeName;
#define BONDEM_ARRAY(type, word)                                                                                            \
    template <int axes> struct TypeName<Array<type, axes>> { static constexpr const char *name = word " written"; };        \
    template <int axes> struct TypeName<Array<const type, axes>> { static constexpr const char *name = word " read"; };
#define BONDEM_NUMBER(type, word) \
    template <> struct TypeName<type> { static constexpr const char *name = word; };
BONDEM_NUMBER(double, "float64")
BONDEM_NUMBER(Index, "int64")
// Types of members of a row that are several numbers; the shape of the member states how many.
BONDEM_NUMBER(Vector, "float64")
BONDEM_NUMBER(Quaternion<double>, "float64")
BONDEM_ARRAY(double, "float64")
BONDEM_ARRAY(float, "float32")
BONDEM_ARRAY(Index, "int64")
BONDEM_ARRAY(int32_t, "int32")
BONDEM_ARRAY(Short, "uint32")
BONDEM_ARRAY(uint8_t, "uint8")

template <class T> struct Described;  // fields of a table

#define BONDEM_FIELD(field, shape) \
    { #field, TypeName<decltype(T::field)>::name, shape, Index(offsetof(T, field)) }
#define BONDEM_TABLE(table, ...)                                    \
    template <> struct Described<table> {                           \
        using T = table;                                            \
        static constexpr FieldDescription fields[] = {__VA_ARGS__}; \
    };

template <class T> constexpr TableDescription described() {
    return {TableName<T>::name, Index(sizeof(T)), Described<T>::fields,
            Index(sizeof(Described<T>::fields) / sizeof(FieldDescription))};
}

}  // namespace bondem
