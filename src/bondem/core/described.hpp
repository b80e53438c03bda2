// Descriptions of tables for Python: `_core.py` reads names, types, shapes and offsets from the library that it has
// loaded, and checks its own tables against them.
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
template <> struct TypeName<double> { static constexpr const char *name = "float64"; };
// Numbers of the members of a row, which is no table itself, by their shape.
template <> struct TypeName<Vector> { static constexpr const char *name = "float64"; };
template <> struct TypeName<Quaternion<double>> { static constexpr const char *name = "float64"; };
template <> struct TypeName<Index> { static constexpr const char *name = "int64"; };
template <> struct TypeName<Array<double, 1>> { static constexpr const char *name = "float64 written"; };
template <> struct TypeName<Array<double, 2>> { static constexpr const char *name = "float64 written"; };
template <> struct TypeName<Array<double, 3>> { static constexpr const char *name = "float64 written"; };
template <> struct TypeName<Array<Index, 1>> { static constexpr const char *name = "int64 written"; };
template <> struct TypeName<Array<Index, 2>> { static constexpr const char *name = "int64 written"; };
template <> struct TypeName<Array<int32_t, 1>> { static constexpr const char *name = "int32 written"; };
template <> struct TypeName<Array<int32_t, 2>> { static constexpr const char *name = "int32 written"; };
template <> struct TypeName<Array<uint8_t, 1>> { static constexpr const char *name = "uint8 written"; };
template <> struct TypeName<Array<uint8_t, 2>> { static constexpr const char *name = "uint8 written"; };
template <> struct TypeName<Array<const float, 3>> { static constexpr const char *name = "float32 read"; };
template <> struct TypeName<Array<const float, 2>> { static constexpr const char *name = "float32 read"; };
template <> struct TypeName<Array<Short, 1>> { static constexpr const char *name = "uint32 written"; };
template <> struct TypeName<Array<float, 1>> { static constexpr const char *name = "float32 written"; };
template <> struct TypeName<Array<const double, 1>> { static constexpr const char *name = "float64 read"; };
template <> struct TypeName<Array<const double, 2>> { static constexpr const char *name = "float64 read"; };
template <> struct TypeName<Array<const double, 3>> { static constexpr const char *name = "float64 read"; };
template <> struct TypeName<Array<const Index, 1>> { static constexpr const char *name = "int64 read"; };
template <> struct TypeName<Array<const int32_t, 1>> { static constexpr const char *name = "int32 read"; };
template <> struct TypeName<Array<const int32_t, 2>> { static constexpr const char *name = "int32 read"; };
template <> struct TypeName<Array<const Index, 2>> { static constexpr const char *name = "int64 read"; };
template <> struct TypeName<Array<const uint8_t, 1>> { static constexpr const char *name = "uint8 read"; };
template <> struct TypeName<Array<const uint8_t, 2>> { static constexpr const char *name = "uint8 read"; };
template <> struct TypeName<Array<const Short, 1>> { static constexpr const char *name = "uint32 read"; };

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
