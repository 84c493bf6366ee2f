// Has the compiler quote a file of the machine.
#include "/etc/passwd"
