:- module(sg_travel,
          [ travel/4,                   % +Start, +How, +Strokess, -Travel
            fold_travel/4               % :Goal, +Travel, +State0, -State
          ]).
:- use_module('../kernel',
              [chain_strokes/4, travel_numbers/4, travel_open/7]).
:- use_module(library(apply), [foldl/4, foldl/5]).
:- use_module(library(lists), [member/2, reverse/2]).
/** <module> Travel: strokes in an order that a lifted pen likes.

From where a stroke ends the pen goes to the nearest end of those not yet
drawn, and draws from there. That may leave ends behind that are far away; where
the way is no shorter than in the order that was given, that order stays.

    travel(Order, Count, Begins, Strokess, Way, Unsorted)
        Order, a handle, has the numbers of Count strokes in the order in which
        they are drawn. Begins and Strokess are compounds: of what is drawn, one
        or many strokes (stroke.pl), and the number of the first of each. Way:
        how far the lifted pen goes; Unsorted: how far in the order that was
        given.
*/

:- set_prolog_flag(optimise, true).

%!  travel(+Start, +How, +Strokess, -Travel) is det.
%
%   Travel is how a plotter that begins at Start, X-Y, draws Strokess
%   (stroke.pl): if How is `short` in an order in which it has no longer way,
%   some of them backwards; as they are if it is `kept`.

travel(Start, How, Strokess, travel(Order,Count,Begins,Parts,Way,Unsorted)) :-
    travel_open(Start, How, Strokess, Order, Count, Way, Unsorted),
    foldl(begin, Strokess, Firsts, 1, _),
    compound_name_arguments(Begins, begins, Firsts),
    compound_name_arguments(Parts, strokes, Strokess).

begin(strokes(_,_,_,_,From,To), First, Begin, End) =>
    First = Begin,
    End is Begin+To-From+1.
begin(_, First, Begin, End) =>
    First = Begin,
    End is Begin+1.

%!  fold_travel(:Goal, +Travel, +State0, -State) is det.
%
%   As foldl/4, of the strokes of Travel as they are drawn. Each is a term for
%   as long as Goal has it.

:- meta_predicate fold_travel(3, +, +, -).

fold_travel(Goal, Travel, State0, State) :-
    fold_from(1, Goal, Travel, State0, State).

fold_from(From, Goal, Travel, State0, State) :-
    Travel = travel(Order, Count, Begins, Strokess, _, _),
    (   From > Count
    ->  State = State0
    ;   To is min(Count, From+999),
        travel_numbers(Order, From, To, Numbers),
        foldl(fold_number(Goal, Begins, Strokess), Numbers, State0, State1),
        Next is To+1,
        fold_from(Next, Goal, Travel, State1, State)
    ).

fold_number(Goal, Begins, Strokess, Number, State0, State) :-
    N is abs(Number),
    functor(Begins, _, Count),
    part_of(N, Begins, 1, Count, Part),
    arg(Part, Begins, Begin),
    arg(Part, Strokess, Strokes),
    Place is N-Begin,
    stroke_at(Strokes, Place, Stroke0),
    (   Number > 0
    ->  Stroke = Stroke0
    ;   backwards(Stroke0, Stroke)
    ),
    call(Goal, Stroke, State0, State).

%   part_of(N, Begins, Low, High, Part): the last that does not begin after N.

part_of(_, _, Low, Low, Part) :-
    !,
    Part = Low.
part_of(N, Begins, Low, High, Part) :-
    Middle is (Low+High+1)//2,
    arg(Middle, Begins, Begin),
    (   Begin =< N
    ->  part_of(N, Begins, Middle, High, Part)
    ;   Below is Middle-1,
        part_of(N, Begins, Low, Below, Part)
    ).

stroke_at(strokes(_,_,_,Chains,From,_), Place, Stroke) =>
    K is From+Place,
    chain_strokes(Chains, K, K, [Stroke]).
stroke_at(Single, _, Stroke) =>
    Stroke = Single.

backwards(stroke(Visibility,Role,S,Es0,Points0,Start,crossed(End,Marks0,L)),
          Stroke) :-
    !,
    findall(Mark, ( member(Mark0, Marks0), Mark is L-Mark0 ), Marks1),
    reverse(Marks1, Marks),
    backwards(stroke(Visibility,Role,S,Es0,Points0,crossed(Start,Marks,L),End),
              Stroke).
backwards(stroke(Visibility,Role,S,Es0,Points0,Start,End),
          stroke(Visibility,Role,S,Es,Points,End,Start)) :-
    reverse(Es0, Es),
    reverse(Points0, Points).
