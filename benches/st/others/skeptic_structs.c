/* 100 parts in an array of structures: updated by kind, searched, sorted by due time */
#include <stdbool.h>
#include "st.h"

#define COUNT 100

enum kind { RAW, MILLED, DRILLED, PAINTED, SCRAP };

struct part {
    int32_t id, due;
    int16_t kind;
    uint8_t tool;
    uint16_t flags;
    int16_t count;
    float weight;
};

static bool before(const struct part *a, const struct part *b)
{
    if (a->due != b->due)
        return a->due < b->due;
    return a->id < b->id;
}

static int16_t sort_parts(struct part *list)
{
    int16_t moves = 0;
    for (int i = 1; i < COUNT; i++) {
        struct part p = list[i];
        int k = i;
        while (k > 0 && before(&p, &list[k - 1])) {
            list[k] = list[k - 1];
            k--;
            moves++;
        }
        list[k] = p;
    }
    return moves;
}

/* index of the first part that is due at or after the time, COUNT if there is none */
static int lower_bound(const struct part *list, int32_t due)
{
    int lo = 0, hi = COUNT;
    while (lo < hi) {
        int mid = (lo + hi) / 2;
        if (list[mid].due < due)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

static struct part *find_id(struct part *list, int32_t id)
{
    for (struct part *p = list; p < list + COUNT; p++)
        if (p->id == id)
            return p;
    return 0;
}

static uint32_t seed = 0x0BADF00D;
static struct part parts[COUNT];
static int32_t now, newest;

static inline uint32_t next_random(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    return seed;
}

static void fill(void)
{
    for (int i = 1; i <= COUNT; i++) {
        struct part *p = &parts[i - 1];
        p->id = i;
        p->due = 50 * i;
        p->weight = 1.0f + (float)i * 0.25f;
        p->count = (int16_t)(i % 7);
    }
    newest = COUNT;
}

static void update(struct part *p, int32_t r)
{
    switch (p->kind) {
    case RAW:
        p->weight *= 0.99f;
        if (r < 400) {
            p->kind = MILLED;
            p->tool = (uint8_t)(r % 16);
        }
        break;
    case MILLED:
        p->flags ^= (uint16_t)(1u << (r % 16));
        p->due += r % 40 - 15;
        if ((p->flags & 0x8001) == 0x8001)
            p->kind = DRILLED;
        break;
    case DRILLED:
        p->count++;
        if (p->count % 13 == 0) {
            p->kind = PAINTED;
            p->weight += 0.5f;
        } else if (r > 4000) {
            p->kind = SCRAP;
        }
        break;
    case PAINTED:
        if (p->due < now) {
            p->kind = SCRAP;
            p->tool |= 0x80;
        } else {
            p->due -= r % 8;
        }
        break;
    default:
        p->id = ++newest;
        p->due = now + 4000 + r;
        p->kind = RAW;
        p->flags = 0;
        p->count = 0;
        p->weight = 20.0f + (float)r / 256.0f;
    }
}

void scan(void)
{
    static bool filled;

    if (!filled) {
        filled = true;
        fill();
    }

    now += 10;
    float total = 0.0f;
    for (struct part *p = parts; p < parts + COUNT; p++) {
        update(p, (int32_t)(next_random() & 0xFFF));
        total += p->weight;
    }

    uint32_t sum = (uint32_t)sort_parts(parts);

    for (int n = 0; n < 10; n++) {
        int32_t r = (int32_t)(next_random() & 0xFFFF);
        sum += (uint32_t)lower_bound(parts, now + r % 5000) + 1;
        struct part *p = find_id(parts, newest - r % 200);
        if (!p)
            continue;
        sum += (uint32_t)(p->count + p->tool);
        if (p->flags & 0x00F0)
            p->due += 100;
    }

    int heaviest = 0;
    for (int i = 1; i < COUNT; i++) {
        if (parts[i].weight > parts[heaviest].weight)
            heaviest = i;
        sum = sum * 3 + (uint32_t)(parts[i].id - parts[i].due);
    }
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)(heaviest + 1) + (uint32_t)(int32_t)total);
}
