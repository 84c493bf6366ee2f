// Threads without end.
static void* rest(void*) {
    pause();
    return nullptr;
}
static void attack() {
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 16384);
    int made = 0;
    for (int i = 0; i < 100000; ++i) {
        pthread_t thread;
        if (pthread_create(&thread, &small, rest, nullptr) != 0) break;
        if (++made > 1000) return breach("more than 1,000 threads");
    }
}
