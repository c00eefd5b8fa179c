/* bottle tracking: records in arrays, update, search, statistics, sort */
#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t Id;
    int16_t Weight, Station, Status;
    float Temp;
    bool Good;
} bottle_t;

typedef struct {
    int16_t Count, Rejects;
    int32_t WeightSum;
    float MaxTemp;
} stat_t;

typedef struct {
    bool Found;
    int16_t Place;
} search_t;

static void Search(search_t *s, int32_t wanted, bottle_t *list)
{
    int16_t n;

    s->Found = false;
    s->Place = 0;
    for (n = 0; n < 100; n++) {
        if (list[n].Id == wanted) {
            s->Found = true;
            s->Place = n + 1;
            break;
        }
    }
}

static bool Init;
static int32_t Seed = 99, NextId = 1000;
static int16_t Wr;
static bottle_t Track[100], Sorted[70];
static stat_t Stat[8];
static search_t Scanner, Reader;

void scan(void)
{
    int16_t i, j, k;
    int32_t Sum;
    bottle_t Tmp;

    if (!Init) {
        for (i = 1; i <= 100; i++) {
            Track[i - 1].Id = 900 + i;
            Track[i - 1].Weight = 500 + i % 30;
            Track[i - 1].Station = i % 8 + 1;
            Track[i - 1].Temp = 20.0f + (float)i * 0.1f;
            Track[i - 1].Good = true;
        }
        Init = true;
    }

    /* three new bottles per cycle overwrite the oldest */
    for (k = 1; k <= 3; k++) {
        Seed = (Seed * 171 + 11213) % 53125;
        NextId = NextId + 1;
        Tmp.Id = NextId;
        Tmp.Weight = 480 + Seed % 60;
        Tmp.Station = 1;
        Tmp.Status = 0;
        Tmp.Temp = 18.0f + (float)(Seed % 50) * 0.2f;
        Tmp.Good = true;
        Track[Wr] = Tmp;
        Wr = Wr + 1;
        if (Wr >= 100)
            Wr = 0;
    }
    if (NextId > 1000000)
        NextId = 1000;

    /* update every bottle */
    for (i = 0; i < 100; i++) {
        switch (Track[i].Status) {
        case 0: /* on the belt */
            if (Track[i].Weight < 490) {
                Track[i].Good = false;
                Track[i].Status = 3;
            } else if (Track[i].Weight > 530) {
                Track[i].Status = 2;
            } else {
                Track[i].Status = 1;
            }
            break;
        case 1: /* moving on */
            Track[i].Station = Track[i].Station + 1;
            Track[i].Temp = Track[i].Temp + (62.0f - Track[i].Temp) * 0.05f;
            if (Track[i].Station > 8) {
                Track[i].Station = 1;
                Track[i].Status = 0;
            }
            break;
        case 2: /* overfilled, drips */
            Track[i].Weight = Track[i].Weight - 1;
            if (Track[i].Weight <= 530)
                Track[i].Status = 1;
            break;
        default:
            Track[i].Temp = Track[i].Temp * 0.99f;
            break;
        }
    }

    /* statistics per station */
    for (i = 0; i < 8; i++) {
        Stat[i].Count = 0;
        Stat[i].Rejects = 0;
        Stat[i].WeightSum = 0;
        Stat[i].MaxTemp = 0.0f;
    }
    for (i = 0; i < 100; i++) {
        j = Track[i].Station - 1;
        Stat[j].Count = Stat[j].Count + 1;
        Stat[j].WeightSum = Stat[j].WeightSum + Track[i].Weight;
        if (!Track[i].Good)
            Stat[j].Rejects = Stat[j].Rejects + 1;
        if (Track[i].Temp > Stat[j].MaxTemp)
            Stat[j].MaxTemp = Track[i].Temp;
    }

    /* search by number */
    Sum = 0;
    for (k = 1; k <= 6; k++) {
        Seed = (Seed * 171 + 11213) % 53125;
        Search(&Scanner, NextId - Seed % 130, Track);
        if (Scanner.Found)
            Sum = Sum + Scanner.Place + Track[Scanner.Place - 1].Weight;
        else
            Sum = Sum + 1;
    }
    Search(&Reader, NextId, Track);
    if (Reader.Found)
        Track[Reader.Place - 1].Weight = Track[Reader.Place - 1].Weight + 2;

    /* the first 70 sorted by weight */
    for (i = 0; i < 70; i++)
        Sorted[i] = Track[i];
    for (i = 1; i < 70; i++) {
        Tmp = Sorted[i];
        j = i - 1;
        while (j >= 0) {
            if (Sorted[j].Weight <= Tmp.Weight)
                break;
            Sorted[j + 1] = Sorted[j];
            j = j - 1;
        }
        Sorted[j + 1] = Tmp;
    }

    for (i = 0; i < 8; i++)
        Sum = Sum + Stat[i].Count * 3 + Stat[i].Rejects * 5 + Stat[i].WeightSum + (int32_t)(Stat[i].MaxTemp * 4.0f);
    Sum = Sum + Sorted[0].Weight + Sorted[19].Id % 1000 + Sorted[69].Station;
    check = (check + Sum) % 10000000;
}
