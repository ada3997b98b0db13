/* QEMU plugin: how many instructions ran inside given address ranges, exactly.
 *
 * Debian ships no plugin header, so the few functions used are declared here (QEMU documentation, "TCG Plugins").
 * Arguments: out=FILE, range=BEGIN:END:NAME (hexadecimal, END exclusive), up to 256. Writes "<count> <name>" per range
 * and "<count> total". Compile with -DPLUGIN_API=1 for QEMU 7, -DPLUGIN_API=4 for QEMU 10. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef PLUGIN_API
#define PLUGIN_API 1
#endif

typedef uint64_t plugin_id;
struct translation_block;
struct instruction;
typedef void (*translated)(plugin_id, struct translation_block*);
typedef void (*executed)(unsigned cpu, void* data);
typedef void (*ended)(plugin_id, void* data);
extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, translated);
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct instruction*, executed, int flags, void* data);
extern void qemu_plugin_register_atexit_cb(plugin_id, ended, void* data);
extern size_t qemu_plugin_tb_n_insns(const struct translation_block*);
extern struct instruction* qemu_plugin_tb_get_insn(const struct translation_block*, size_t index);
extern uint64_t qemu_plugin_insn_vaddr(const struct instruction*);

#define VISIBLE __attribute__((visibility("default")))
VISIBLE int qemu_plugin_version = PLUGIN_API;

struct range {
  uint64_t begin, end, count;
  char name[128];
};

static struct range ranges[257]; /* the last used one counts what lies in no range */
static unsigned used;
static FILE* out;

static void count(unsigned cpu, void* data) {
  (void)cpu;
  ++((struct range*)data)->count;
}

static struct range* range_of(uint64_t address) {
  unsigned i = 0;
  while (i < used && !(address >= ranges[i].begin && address < ranges[i].end)) ++i;
  return &ranges[i];
}

static void translate(plugin_id id, struct translation_block* block) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    struct instruction* instruction = qemu_plugin_tb_get_insn(block, i);
    qemu_plugin_register_vcpu_insn_exec_cb(instruction, count, 0, range_of(qemu_plugin_insn_vaddr(instruction)));
  }
}

static void report(plugin_id id, void* data) {
  uint64_t total = ranges[used].count;
  (void)id;
  (void)data;
  for (unsigned i = 0; i < used; ++i) {
    fprintf(out, "%" PRIu64 " %s\n", ranges[i].count, ranges[i].name);
    total += ranges[i].count;
  }
  fprintf(out, "%" PRIu64 " total\n", total);
  fclose(out);
}

VISIBLE int qemu_plugin_install(plugin_id id, const void* info, int argc, char** argv) {
  (void)info;
  for (int i = 0; i < argc; ++i) {
    struct range* range = &ranges[used];
    if (!strncmp(argv[i], "out=", 4)) out = fopen(argv[i] + 4, "w");
    if (used < 256 && sscanf(argv[i], "range=%" SCNx64 ":%" SCNx64 ":%127s", &range->begin, &range->end, range->name) == 3)
      ++used;
  }
  if (!out) out = stderr;
  qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
  qemu_plugin_register_atexit_cb(id, report, 0);
  return 0;
}
