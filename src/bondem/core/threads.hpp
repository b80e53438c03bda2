// Threads of the core. Work is divided into tasks, and no result depends on how many threads share them.
#pragma once
#include "scalars.hpp"

namespace bondem {

// Calls work(task, data) for task = 0 … tasks - 1 on at most `threads` threads; returns when all are done. The caller
// does all tasks itself if the threads work for another caller, or if it is within a task.
void share_tasks(Index threads, Index tasks, void (*work)(Index task, void *data), void *data);

template <class Task> inline void for_each_task(Index threads, Index tasks, Task task) {
    share_tasks(threads, tasks, [](Index number, void *data) { (*static_cast<Task *>(data))(number); }, &task);
}
// Calls on(i) for i = 0 … count - 1, in tasks of `size` each.
template <class On> inline void for_each_in_tasks(Index threads, Index count, Index size, On on) {
    for_each_task(threads, (count + size - 1) / size, [=](Index task) {
        for (Index i = task * size; i < least((task + 1) * size, count); i++) on(i);
    });
}

}  // namespace bondem
