/* A union of two tetrahedra, and its exact volume: the example of docs/c.md. */
#include <quoin/quoin_c.h>
#include <stdio.h>

static quoin_solid* tetrahedron(double x, quoin_error* error) {
  const double points[] = {x, x, x, x + 6, x, x, x, x + 6, x, x, x, x + 6};
  const uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  quoin_solid* solid;
  quoin_solid_from_triangles((quoin_array){points, 12, QUOIN_FLOAT64}, (quoin_array){triangles, 12, QUOIN_UINT32}, NULL,
                             NULL, &solid, error);
  return solid;
}

int main(void) {
  quoin_error error;
  const quoin_solid* solids[] = {tetrahedron(0, &error), tetrahedron(1, &error)};
  quoin_solid* both = NULL;
  char* volume = NULL;
  if (quoin_unite(solids, 2, NULL, NULL, &both, &error) == QUOIN_OK)
    if (quoin_solid_volume(both, &volume, &error) == QUOIN_OK) printf("volume %s\n", volume);
  if (error.code != QUOIN_OK) fprintf(stderr, "%s [%s]\n", error.message, quoin_code_name(error.code));

  quoin_text_free(volume);
  quoin_solid_free(both);
  quoin_solid_free((quoin_solid*)solids[0]);
  quoin_solid_free((quoin_solid*)solids[1]);
  return error.code != QUOIN_OK;
}
