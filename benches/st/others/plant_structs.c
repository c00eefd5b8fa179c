/* Batch list: array of structs, update, search, totals, sorting */
#include <stdbool.h>
#include "st.h"

#define BATCHES 47
#define LINES 3

typedef struct {
    float rTemp;
    float rWeight;
    bool xOk;
} Quality;

typedef struct {
    int16_t iLine;
    int32_t diId;
    int32_t diPrio;
    int32_t diCount;
    bool xActive;
    Quality stQual;
} Batch;

typedef struct {
    int32_t diCount;
    int32_t diBad;
    float rWeight;
} LineSum;

static int32_t FindBatch(int32_t diId, Batch *astList)
{
    int32_t i;

    for (i = 0; i <= BATCHES; i++) {
        if (astList[i].diId == diId)
            return i;
    }
    return -1;
}

static int32_t diScan;
static bool xInit;
static Batch astBatch[BATCHES + 1];
static LineSum astLine[LINES + 1];

void scan(void)
{
    int32_t i, j, k, diIdx;
    Batch stTmp;

    if (!xInit) {
        xInit = true;
        for (i = 0; i <= BATCHES; i++) {
            astBatch[i].diId = 1000 + i;
            astBatch[i].iLine = (int16_t)(i % 4);
            astBatch[i].diPrio = (i * 37) % 101;
            astBatch[i].stQual.rTemp = 20.0f;
        }
    }

    diScan = diScan + 1;

    /* update */
    for (i = 0; i <= BATCHES; i++) {
        astBatch[i].xActive = (astBatch[i].diId + diScan) % 3 != 0;
        if (astBatch[i].xActive) {
            astBatch[i].diCount = astBatch[i].diCount + 1;
            astBatch[i].stQual.rTemp = astBatch[i].stQual.rTemp + (60.0f - astBatch[i].stQual.rTemp) * 0.05f;
            astBatch[i].stQual.rWeight = astBatch[i].stQual.rWeight + 0.25f;
        } else {
            astBatch[i].stQual.rTemp = astBatch[i].stQual.rTemp - 1.5f;
        }
        astBatch[i].stQual.xOk = astBatch[i].stQual.rTemp > 35.0f && astBatch[i].stQual.rTemp < 58.0f;
        if (astBatch[i].stQual.rWeight > 500.0f)
            astBatch[i].stQual.rWeight = 0.0f;
    }

    /* totals of each line */
    for (k = 0; k <= LINES; k++) {
        astLine[k].diCount = 0;
        astLine[k].diBad = 0;
        astLine[k].rWeight = 0.0f;
    }
    for (i = 0; i <= BATCHES; i++) {
        k = astBatch[i].iLine;
        astLine[k].diCount = astLine[k].diCount + astBatch[i].diCount;
        astLine[k].rWeight = astLine[k].rWeight + astBatch[i].stQual.rWeight;
        if (!astBatch[i].stQual.xOk)
            astLine[k].diBad = astLine[k].diBad + 1;
    }

    /* new priorities of some batches */
    for (j = 0; j <= 5; j++) {
        diIdx = FindBatch(1000 + (diScan * 7 + j * 5) % 48, astBatch);
        if (diIdx >= 0) {
            astBatch[diIdx].diPrio = (diScan * 31 + j * 17) % 101;
            check = check + diIdx;
        }
    }

    /* insertion sort by priority */
    for (i = 1; i <= BATCHES; i++) {
        stTmp = astBatch[i];
        j = i - 1;
        while (j >= 0) {
            if (astBatch[j].diPrio <= stTmp.diPrio)
                break;
            astBatch[j + 1] = astBatch[j];
            j = j - 1;
        }
        astBatch[j + 1] = stTmp;
    }

    for (k = 0; k <= LINES; k++)
        check = check * 3 + astLine[k].diCount + astLine[k].diBad + (int32_t)astLine[k].rWeight;
    check = check + astBatch[0].diId * 3 + astBatch[BATCHES].diId;
}
