/* What the programs beside the ones in Structured Text share; main.c defines both variables. */
#include <stdint.h>

extern uint64_t now_us;
extern int32_t check;

/* One scan of the program. */
void scan(void);
