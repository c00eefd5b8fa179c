/* A course of 100 students: every scan some marks come in, the records are
   brought up to date, and a bubble sort of at most 20 passes ranks them. */
#include <stdbool.h>
#include "st.h"

#define STUDENTS 100
#define EXAMS 5

typedef enum { FAILED, PASSED, DISTINCTION } Outcome;

typedef struct {
    int32_t number;
    int32_t points;
    float average;
    int16_t exams;
    Outcome outcome;
    bool active;
    int16_t marks[EXAMS];
} Student;

static int32_t seed = 2024;

static int32_t next_random(void)
{
    seed = (seed * 25173 + 13849) % 65536;
    return seed / 16;
}

static Outcome outcome_of(float average)
{
    if (average >= 70.0f)
        return DISTINCTION;
    if (average >= 40.0f)
        return PASSED;
    return FAILED;
}

static void record_mark(Student *student, int exam, int16_t mark)
{
    student->marks[exam] = mark;
    student->exams = (student->exams + 1) % 1000;
    student->points = 0;
    for (int i = 0; i < EXAMS; i++)
        student->points += student->marks[i];
    student->average = (float)student->points / 5.0f;
    student->outcome = outcome_of(student->average);
    student->active = mark > 0;
}

/* The best come first; of equals the one with the lower number. */
static int32_t rank_students(Student *students, int passes)
{
    int32_t swaps = 0;
    for (int pass = 1; pass <= passes; pass++) {
        for (int i = 0; i < STUDENTS - pass; i++) {
            if (students[i].points < students[i + 1].points
                || (students[i].points == students[i + 1].points
                    && students[i].number > students[i + 1].number)) {
                Student held = students[i];
                students[i] = students[i + 1];
                students[i + 1] = held;
                swaps++;
            }
        }
    }
    return swaps;
}

static Student students[STUDENTS];
static bool initialised;
static int32_t scan_count;

void scan(void)
{
    if (!initialised) {
        for (int i = 0; i < STUDENTS; i++)
            students[i].number = 1000 + i;
        initialised = true;
    }

    /* Everybody gets a mark for the exam of the day. */
    scan_count++;
    int exam = scan_count % EXAMS;
    for (int i = 0; i < STUDENTS; i++)
        record_mark(&students[i], exam, next_random() % 101);

    int32_t sum = rank_students(students, 20);

    for (int i = 0; i < STUDENTS; i++) {
        sum += students[i].number % 100 * (i % 7);
        if (students[i].active)
            sum += students[i].exams;
        switch (students[i].outcome) {
        case PASSED:
            sum += 10;
            break;
        case DISTINCTION:
            sum += (int32_t)(students[i].average * 2.0f);
            break;
        default:
            break;
        }
    }
    check = (check * 31 + sum) % 1000003;
}
