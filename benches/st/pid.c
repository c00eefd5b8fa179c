/* The same work as pid.st. */
#include "st.h"

static float setpoint[64], actual[64], integral[64], last[64], output[64];
static int32_t scans;

void scan(void)
{
    if (scans % 200 == 0)
        for (int32_t i = 0; i < 64; i++)
            setpoint[i] = (float)((i * 3 + scans / 200) % 100);
    for (int32_t i = 0; i < 64; i++) {
        float e = setpoint[i] - actual[i];
        float sum = integral[i] + e * 0.01f;
        if (sum > 100.0f)
            sum = 100.0f;
        else if (sum < -100.0f)
            sum = -100.0f;
        integral[i] = sum;
        float y = 2.0f * e + 0.5f * sum + 0.1f * (e - last[i]);
        if (y > 100.0f)
            y = 100.0f;
        else if (y < 0.0f)
            y = 0.0f;
        last[i] = e;
        output[i] = y;
        actual[i] = actual[i] + (y - actual[i]) * 0.05f;
    }
    check += (int32_t)(output[scans % 64] * 100.0f);
    scans++;
}
