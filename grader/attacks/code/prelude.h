// Stands before every attack: what an attacker would have at hand.
#include <arpa/inet.h>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/vm_sockets.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "ProgRef.h"

// An attack says itself where it got through; the judge looks for this line.
static void breach(const char* what) { dprintf(1, "breach: %s\n", what); }

static const char* const fullMarks =
    "{\"schema\": \"radlab/result/1\", \"score\": 100, \"max_score\": 100, \"stages\": []}\n";
