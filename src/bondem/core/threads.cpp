// A pool of threads, which start at the first use and remain. The pool shares the tasks of one caller at a time.
#include "threads.hpp"

#include <pthread.h>
#include <unistd.h>

namespace bondem {
namespace {

constexpr int most_threads = 256;
// Number of times that a thread reads the flag before it sleeps, some microseconds: saves wake-ups between passes.
constexpr int spins = 2000;

inline void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

// Threads that share n tasks in contiguous parts: thread t of k has tasks t n / k … (t + 1) n / k - 1.
struct Team {
    pthread_mutex_t busy, lock;  // held while tasks are shared; guards what follows
    pthread_cond_t start, ended;
    int started;  // threads in addition to the caller
    int process;  // process that started them; a fork of it has no threads
    Index tasks;
    void (*work)(Index, void *);
    void *data;
    // Generation of the work, which counts up with each new work, and in the last 16 bits the number of members that
    // share it, the caller included. Both are one number, so that a late thread cannot join work for which it was not
    // counted.
    uint64_t call;
    int left;  // members still at work
};

Team team = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, PTHREAD_COND_INITIALIZER,
             0, 0, 0, nullptr, nullptr, 0, 0};

constexpr uint64_t members_of(uint64_t call) { return call & 0xffff; }

void do_share(int member, int members) {
    const Index first = team.tasks * member / members, last = team.tasks * (member + 1) / members;
    for (Index task = first; task < last; task++) team.work(task, team.data);
}

uint64_t next_call(uint64_t seen) {
    for (int turn = 0; turn < spins; turn++) {
        const uint64_t now = __atomic_load_n(&team.call, __ATOMIC_ACQUIRE);
        if (now != seen) return now;
        pause();
    }
    pthread_mutex_lock(&team.lock);
    while (team.call == seen) pthread_cond_wait(&team.start, &team.lock);
    const uint64_t now = team.call;
    pthread_mutex_unlock(&team.lock);
    return now;
}

struct Recruit {
    int member;
    uint64_t seen;  // call when the thread was started
};
Recruit recruits[most_threads];

void *serve(void *recruit) {
    const int member = static_cast<Recruit *>(recruit)->member;
    uint64_t call = static_cast<Recruit *>(recruit)->seen;
    for (;;) {
        call = next_call(call);
        const int members = int(members_of(call));
        if (member >= members) continue;
        do_share(member, members);
        if (__atomic_sub_fetch(&team.left, 1, __ATOMIC_ACQ_REL) == 0) {
            pthread_mutex_lock(&team.lock);
            pthread_cond_signal(&team.ended);
            pthread_mutex_unlock(&team.lock);
        }
    }
    return nullptr;
}

// Starts threads until `wanted` exist besides the caller, fewer if the system refuses more; returns their number.
int started(int wanted) {
    if (team.process != getpid()) {
        // A forked child has none of the parent's threads, which still count as idle: conditions on which they slept
        // would block the child.
        static const pthread_mutex_t unlocked = PTHREAD_MUTEX_INITIALIZER;
        static const pthread_cond_t nobody_waits = PTHREAD_COND_INITIALIZER;
        team.lock = unlocked;
        team.start = team.ended = nobody_waits;
        team.process = getpid();
        team.started = 0;
    }
    while (team.started < wanted) {
        pthread_t thread;
        Recruit &recruit = recruits[team.started];
        recruit = {team.started + 1, team.call};
        if (pthread_create(&thread, nullptr, serve, &recruit) != 0) break;
        pthread_detach(thread);
        team.started++;
    }
    return team.started;
}

void wait_for_all() {
    for (int turn = 0; turn < spins; turn++) {
        if (__atomic_load_n(&team.left, __ATOMIC_ACQUIRE) == 0) return;
        pause();
    }
    pthread_mutex_lock(&team.lock);
    while (__atomic_load_n(&team.left, __ATOMIC_ACQUIRE) != 0) pthread_cond_wait(&team.ended, &team.lock);
    pthread_mutex_unlock(&team.lock);
}

}  // namespace

void share_tasks(Index threads, Index tasks, void (*work)(Index, void *), void *data) {
    int members = int(least(least(threads, tasks), Index(most_threads)));
    if (members > 1 && pthread_mutex_trylock(&team.busy) == 0) {
        members = least(members, started(members - 1) + 1);
        pthread_mutex_lock(&team.lock);
        team.tasks = tasks;
        team.work = work;
        team.data = data;
        __atomic_store_n(&team.left, members - 1, __ATOMIC_RELEASE);
        __atomic_store_n(&team.call, ((team.call >> 16) + 1) << 16 | uint64_t(members), __ATOMIC_RELEASE);
        pthread_cond_broadcast(&team.start);
        pthread_mutex_unlock(&team.lock);
        do_share(0, members);
        wait_for_all();
        pthread_mutex_unlock(&team.busy);
        return;
    }
    for (Index task = 0; task < tasks; task++) work(task, data);
}

}  // namespace bondem
