/* The digits of a number as a text, and how many there are. */
static int digits(int number, char *to)
{
    char reversed[12];
    int count = 0;
    do {
        reversed[count++] = '0' + number % 10;
        number /= 10;
    } while (number);
    for (int i = 0; i < count; i++)
        to[i] = reversed[count - 1 - i];
    to[count] = 0;
    return count;
}
