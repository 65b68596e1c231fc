:- module(sg_csg_en,
          [ csg_en//1                   % +What
          ]).
:- use_module('../csg/csg_term',
              [near_operands/2, operation_form/2, operation_names/1]).
:- use_module('../limits', [limit_value/2]).
:- use_module(message_parts, [meant_en//1]).
:- use_module(primitive_en, [misshapen_en//1, primitive_names//0]).
:- use_module('../csg/operand_name', [operand_name_en//1]).
/** <module> What is wrong with a CSG tree, in English.

csg_ko.pl has the same heads in Korean (tests/rules/csg/csg_faults.plt).
*/

%!  csg_en(+What)// is det.
%
%   The message for model_error(csg(What)), see csg_term.pl.

csg_en(no_list(Name, Operands)) -->
    { operation_form(Name, Form) },
    [ 'the operands of ~w should be a list, not ~p'-[Name, Operands], nl,
      '  Write ~w.'-[Form] ].
csg_en(no_operands(Name)) -->
    [ '~w has no operands'-[Name], nl,
      '  Give one or more: numbers of segments, primitives, or operations.' ].
csg_en(unknown(Operand)) -->
    misshapen_en(Operand),
    !,
    [ nl,
      '  An operand is the number of a segment, a primitive, or an \c
       operation.' ].
csg_en(unknown(Operand)) -->
    { operation_names(Names) },
    [ '~p is no operand'-[Operand] ],
    { near_operands(Operand, Near) },
    meant_en(Near),
    [ nl,
      '  An operand is the number of a segment, an operation (~w), or a \c
       primitive:'-[Names] ],
    primitive_names.
csg_en(side(Side, Sides)) -->
    { atomic_list_concat(Sides, ' or ', Text) },
    [ 'a solid is split on the side ~w here, not ~p'-[Text, Side], nl,
      '  Planes and open surfaces have below and above, solids inside and \c
       outside.' ].
csg_en(plane(By)) -->
    [ '~p is no plane'-[By], nl,
      '  Write plane(A, B, C, D) for A*X + B*Y + C*Z + D = 0, with A, B or C \c
       other than 0.' ].
csg_en(missing(S, Child)) -->
    operand_name_en(S),
    [ ' has the operand ~d, and there is no such segment'-[Child], nl,
      '  Add segment ~d, or correct the number.'-[Child] ].
csg_en(cycle(Path)) -->
    { atomic_list_concat(Path, ' -> ', Text) },
    [ 'a segment is its own operand: ~w'-[Text], nl,
      '  Take one of these out of the operands of the one before it.' ].
csg_en(too_many(S, Leaves)) -->
    { limit_value(nodes, Most) },
    operand_name_en(S),
    [ ' would be made of ~D leaves'-[Leaves], nl,
      '  ~D is the most: use its operands less often, or --limits nodes=N.'-
      [Most] ].
csg_en(no_front(S)) -->
    operand_name_en(S),
    [ ' cannot split a solid: its sides face all ways', nl,
      '  Give a surface that has a front on the whole.' ].
csg_en(not_through(S)) -->
    operand_name_en(S),
    [ ', an open surface, does not go all the way through the solid', nl,
      '  Its border, and what is straight behind it, must be outside of the \c
       solid.' ].
csg_en(curve(S, Child)) -->
    operand_en(S, Child),
    [ ' is no solid but a curve', nl,
      '  Operations are on solids; penetrate shows where a curve goes \c
       through.' ].
csg_en(cells(S, Child, Name)) -->
    operand_en(S, Child),
    [ ' is a model of cells: ~w needs a solid'-[Name], nl,
      '  Give its parts; a glue can be glued again, or be cut by a Boolean.' ].
csg_en(placed(S)) -->
    operand_name_en(S),
    [ ' is glued and placed elsewhere', nl,
      '  Place what is glued: glue([at(Steps, Operand), ...]).' ].
csg_en(surface(S, Child, Name)) -->
    operand_en(S, Child),
    [ ' is an open surface: ~w needs an inside and an outside'-[Name], nl,
      '  An open surface can be united or joined, or split a solid; close it, \c
       or give a solid.' ].

operand_en(S, Child) -->
    { integer(Child) },
    !,
    [ 'operand ~d of '-[Child] ],
    operand_name_en(S).
operand_en(_, Child) -->
    operand_name_en(Child).
