#include "st.h"
#include <stdbool.h>
static bool is_prime[5001];
static int scans;
void scan(void) {
    int limit = 4000 + ++scans % 1000;
    for (int i = 2; i <= limit; i++) is_prime[i] = true;
    for (int i = 2; i * i <= limit; i++)
        if (is_prime[i])
            for (int j = i * i; j <= limit; j += i) is_prime[j] = false;
    int count = 0, largest = 0, sum = 0;
    for (int i = 2; i <= limit; i++)
        if (is_prime[i]) { count++; largest = i; sum += i; }
    check = (check + count + largest + sum) % 1000003;
}
