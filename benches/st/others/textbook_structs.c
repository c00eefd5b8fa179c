#include "st.h"
#include <stdbool.h>
#include <limits.h>
#define N 100
enum quality { UNKNOWN, GOOD, BAD };
struct part { int number; float weight; enum quality quality; };
struct place { bool occupied; int stored; struct part part; };
static struct place store[N];
static int scans;

static int find_free(void) {
    for (int i = 0; i < N; i++)
        if (!store[i].occupied) return i + 1;
    return 0;
}
static int find_oldest(void) {
    int r = 0, oldest = INT_MAX;
    for (int i = 0; i < N; i++)
        if (store[i].occupied && store[i].stored < oldest) { oldest = store[i].stored; r = i + 1; }
    return r;
}
void scan(void) {
    scans++;
    int place = 0;
    for (int k = 1; k <= 3; k++) {
        struct part p;
        p.number = (scans * 3 + k) % 1000;
        p.weight = (float)(p.number % 50) * 0.5f;
        p.quality = p.number % 7 == 0 ? BAD : GOOD;
        place = find_free();
        if (place) {
            store[place - 1].occupied = true;
            store[place - 1].stored = scans;
            store[place - 1].part = p;
        }
    }
    int count = 0, bad = 0, numbers = 0;
    float weight = 0.0f;
    for (int i = 0; i < N; i++)
        if (store[i].occupied) {
            count++;
            weight += store[i].part.weight;
            numbers += store[i].part.number;
            bad += store[i].part.quality == BAD;
        }
    if (count > 90)
        for (int k = 0; k < 5; k++) {
            place = find_oldest();
            if (place) store[place - 1].occupied = false;
        }
    check = (check + count + 3 * bad + (int)weight + numbers + place) % 1000003;
}
