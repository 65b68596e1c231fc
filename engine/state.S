/* state.S -- the rules as bytes of the library: as a saved state, which Prolog
 * starts from, and compiled, for a Prolog that already runs. */
	.section .rodata
	.global sg_state, sg_state_end
	.balign 16
sg_state:
	.incbin SG_STATE
sg_state_end:
	.global sg_rules, sg_rules_end
	.balign 16
sg_rules:
	.incbin SG_RULES
sg_rules_end:
	.section .note.GNU-stack,"",@progbits
