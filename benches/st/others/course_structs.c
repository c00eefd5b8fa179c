/* Course unit 9: a list of workpieces on a conveyor. */
#include "st.h"
#include <stdbool.h>

typedef struct {
    int32_t id;
    int16_t kind;
    bool good;
    float weight;
    int32_t position;
} Workpiece;

typedef struct {
    int16_t good_count;
    float total_weight;
    int32_t heaviest;
    int16_t per_kind[4];
} Summary;

#define COUNT 48

static int32_t next_number(int32_t seed)
{
    return (seed * 1103 + 12345) % 65536;
}

static int16_t find_by_id(int32_t id, const Workpiece *list)
{
    for (int i = 0; i < COUNT; i++)
        if (list[i].id == id)
            return (int16_t)i;
    return -1;
}

static int16_t conveyor(int32_t speed, Workpiece *list)
{
    int16_t removed = 0;
    for (int i = 0; i < COUNT; i++) {
        list[i].position += speed + list[i].kind;
        if (list[i].position > 10000) {
            list[i].position = 0;
            list[i].good = !list[i].good;
            removed++;
        }
    }
    return removed;
}

static int32_t sort_by_weight(Workpiece *list)
{
    int32_t moves = 0;
    for (int i = 1; i < COUNT; i++) {
        Workpiece current = list[i];
        int j = i - 1;
        while (j >= 0 && list[j].weight > current.weight) {
            list[j + 1] = list[j];
            j--;
            moves++;
        }
        list[j + 1] = current;
    }
    return moves;
}

static void statistics(const Workpiece *list, Summary *result)
{
    result->good_count = 0;
    result->total_weight = 0.0f;
    for (int i = 0; i < 4; i++)
        result->per_kind[i] = 0;
    float maximum = -1.0f;
    for (int i = 0; i < COUNT; i++) {
        if (list[i].good) {
            result->good_count++;
            result->total_weight += list[i].weight;
        }
        if (list[i].weight > maximum) {
            maximum = list[i].weight;
            result->heaviest = list[i].id;
        }
        result->per_kind[list[i].kind]++;
    }
}

static int32_t seed = 99;
static bool ready;
static Workpiece parts[COUNT];
static Summary summary;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < COUNT; i++) {
            seed = next_number(seed);
            parts[i].id = 1000 + i;
            parts[i].kind = (int16_t)(i % 4);
            parts[i].good = i % 3 != 0;
            parts[i].weight = (float)(seed % 1000) * 0.1f;
            parts[i].position = i * 200;
        }
        ready = true;
    }

    int32_t sum = conveyor(15, parts);
    for (int i = 1; i <= 8; i++) {
        seed = next_number(seed);
        int16_t found = find_by_id(1000 + seed % 50, parts);
        if (found >= 0) {
            parts[found].weight = (float)(seed % 1000) * 0.1f;
            parts[found].kind = (int16_t)((parts[found].kind + 1) % 4);
            sum += found;
        } else {
            sum += 100;
        }
    }
    int32_t moves = sort_by_weight(parts);
    statistics(parts, &summary);
    sum += moves + summary.good_count + summary.heaviest
         + (int32_t)summary.total_weight + 3 * summary.per_kind[1] + 5 * summary.per_kind[3];
    check = (check * 31 + sum) % 1000003;
}
