// Runs a program for which the kernel refuses what containers often do: refuse-calls namespaces|filters… -- PROGRAM ARGUMENT…

#include <linux/sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

namespace {

constexpr std::uint64_t anyNamespace =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

int refuse(scmp_filter_ctx filter, int failure, int call, std::initializer_list<scmp_arg_cmp> conditions = {}) {
    return seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(static_cast<unsigned>(failure)), call,
                                  static_cast<unsigned>(conditions.size()), conditions.begin());
}

int refuseNamespaces(scmp_filter_ctx filter) {
    int failed = refuse(filter, EPERM, SCMP_SYS(unshare)) | refuse(filter, EPERM, SCMP_SYS(setns)) |
                 refuse(filter, EPERM, SCMP_SYS(mount)) | refuse(filter, ENOSYS, SCMP_SYS(clone3));
    for (std::uint64_t one = 1; one != 0; one <<= 1)
        if (one & anyNamespace)
            failed |= refuse(filter, EPERM, SCMP_SYS(clone), {SCMP_A0(SCMP_CMP_MASKED_EQ, one, one)});
    return failed;
}

int refuseFilters(scmp_filter_ctx filter) {
    return refuse(filter, ENOSYS, SCMP_SYS(seccomp)) |
           refuse(filter, EINVAL, SCMP_SYS(prctl), {SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP)});
}

}  // namespace

int main(int count, char** arguments) {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    int next = 1, failed = filter ? 0 : 1;
    for (; next < count && std::strcmp(arguments[next], "--") != 0; ++next) {
        if (std::strcmp(arguments[next], "namespaces") == 0) failed |= refuseNamespaces(filter);
        if (std::strcmp(arguments[next], "filters") == 0) failed |= refuseFilters(filter);
    }
    if (failed || next + 1 >= count || seccomp_load(filter) != 0) return 125;
    execvp(arguments[next + 1], arguments + next + 1);
    std::perror(arguments[next + 1]);
    return 126;
}
