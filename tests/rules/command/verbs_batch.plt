/* Which part of a batch a command does. */
:- module(test_verbs_batch, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(command/verbs_batch), []).

shard(Text, Shard) :-
    catch(( sg_verbs_batch:shard_of(Text, I, N), Shard = I/N ),
          error(usage_error(What), _), Shard = What).

variable(id, 'SLURM_ARRAY_TASK_ID').
variable(min, 'SLURM_ARRAY_TASK_MIN').
variable(max, 'SLURM_ARRAY_TASK_MAX').
variable(step, 'SLURM_ARRAY_TASK_STEP').
variable(count, 'SLURM_ARRAY_TASK_COUNT').

%   slurm(Values, Shard): where Slurm has set these.

slurm(Values, Shard) :-
    setup_call_cleanup(
        forall(member(Name=Value, Values),
               ( variable(Name, Variable), setenv(Variable, Value) )),
        shard(slurm, Shard),
        forall(variable(_, Variable), unsetenv(Variable))).

:- begin_tests(verbs_batch).

test(shard, [ forall(member(Text-Shard,
       [ '1/1'-(1/1), '1/3'-(1/3), '3/3'-(3/3), '0/3'-no, '4/3'-no, '-1/3'-no,
         '1'-no, '1/2/3'-no, 'a/3'-no, '1/b'-no, '1.0/3'-no, '1/2.0'-no,
         '/3'-no, ''-no ])),
              true(Found == Shard) ]) :-
    shard(Text, Found0),
    (   Found0 = bad_value('--shard', Text, 'I/N')
    ->  Found = no
    ;   Found = Found0
    ).
test(slurm, [ forall(member(Values-Shard,
       [ [id=1,min=1,max=3,count=3]-(1/3), [id=3,min=1,max=3,count=3]-(3/3),
         [id=0,min=0,max=3,count=4]-(1/4), [id=7,min=5,max=8,count=4]-(3/4),
         [id=9,min=1,max=9,step=4,count=3]-(3/3),
         [id=5,min=1,max=9,step=4,count=3]-(2/3),
         [id=5,min=1,max=9,count=3]-batch(slurm_list),
         [id=5,min=1,max=10,step=4,count=3]-batch(slurm_list),
         [min=1,max=3,count=3]-batch(no_slurm),
         [id=1,max=3,count=3]-batch(no_slurm),
         [id=1,min=1,count=3]-batch(no_slurm),
         [id=1,min=1,max=3]-batch(no_slurm),
         [id=x,min=1,max=3,count=3]-batch(no_slurm) ])),
              true(Found == Shard) ]) :-
    slurm(Values, Found).

:- end_tests(verbs_batch).
