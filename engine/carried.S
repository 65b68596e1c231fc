/* carried.S -- the rules as bytes of the library, compiled (tools/parts.pl): the
 * core, which the program loads when it starts; the parts, which it loads when
 * they are called; and all of them, for a Prolog that already runs. */
	.section .rodata
	.global sg_core, sg_core_end
	.balign 16
sg_core:
	.incbin SG_CORE
sg_core_end:
	.global sg_parts, sg_parts_end
	.balign 16
sg_parts:
	.incbin SG_PARTS
sg_parts_end:
	.global sg_rules, sg_rules_end
	.balign 16
sg_rules:
	.incbin SG_RULES
sg_rules_end:
	.section .note.GNU-stack,"",@progbits
