:- module(sg_disjoint_sets,
          [ set_root/3,                 % +Sets, +Member, -Root
            sets_joined/4               % +A, +B, +Sets0, -Sets
          ]).
:- use_module(library(assoc), [get_assoc/3, put_assoc/4]).
/** <module> Disjoint sets: connected components, found link by link.

Sets is an assoc, empty at first: every term is a set by itself then. It has the
size of a root's set, and of other members another one that is nearer to the
root. The smaller set hangs on the larger one, so no way is longer than the
logarithm of their number.
*/

%!  set_root(+Sets, +Member, -Root) is det.
%
%   Root is the member that stands for the set of Member.

set_root(Sets, Member, Root) :-
    (   get_assoc(Member, Sets, on(Next))
    ->  set_root(Sets, Next, Root)
    ;   Root = Member
    ).

%!  sets_joined(+A, +B, +Sets0, -Sets) is det.
%
%   In Sets the sets of A and B are one. Its root is one of theirs.

sets_joined(A, B, Sets0, Sets) :-
    set_root(Sets0, A, RootA),
    set_root(Sets0, B, RootB),
    (   RootA == RootB
    ->  Sets = Sets0
    ;   set_size(Sets0, RootA, SizeA),
        set_size(Sets0, RootB, SizeB),
        Size is SizeA+SizeB,
        (   SizeA >= SizeB
        ->  hung(RootB, RootA, Size, Sets0, Sets)
        ;   hung(RootA, RootB, Size, Sets0, Sets)
        )
    ).

set_size(Sets, Root, Size) :-
    (   get_assoc(Root, Sets, size(Size0))
    ->  Size = Size0
    ;   Size = 1
    ).

hung(Lower, Root, Size, Sets0, Sets) :-
    put_assoc(Lower, Sets0, on(Root), Sets1),
    put_assoc(Root, Sets1, size(Size), Sets).
