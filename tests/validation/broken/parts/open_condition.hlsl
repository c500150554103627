#ifndef OPEN_CONDITION
#define OPEN_CONDITION
float Half(float x) { return 0.5 * x; }
