// Calls home, or the neighbours.
static void attack() {
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0) breach("an internet socket");
    if (socket(AF_INET6, SOCK_DGRAM, 0) >= 0) breach("an internet socket, version 6");
    if (socket(AF_UNIX, SOCK_STREAM, 0) >= 0) breach("a local socket");
    if (socket(AF_VSOCK, SOCK_STREAM, 0) >= 0) breach("a socket to the machine's host");
    if (socket(AF_NETLINK, SOCK_RAW, 0) >= 0) breach("a socket to the kernel");
    if (socket(AF_PACKET, SOCK_RAW, 0) >= 0) breach("a raw socket");
    int pair[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0) breach("a pair of sockets");
}
