:- module(sg_explain_pixel_en,
          [ pixel_statement_en//1,      % +Statement
            pixel_nothing_en//1         % +Item
          ]).
:- use_module(explain_words, [bytes_word/2, segment_word/2]).
/** <module> Explanations of shaded pictures in English; explain_pixel_ko.pl has
them in Korean.
*/

%!  pixel_statement_en(+Statement)// is semidet.
%
%   A statement of explain_pixel.pl in English.

pixel_statement_en(pixel(X, Y, Bytes)) -->
    { bytes_word(Bytes, Word) },
    [ 'dot ~d of row ~d, counted from 0, from the upper left, is ~w'-
      [X, Y, Word] ].
pixel_statement_en(seen_part(Percent, Face, Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~4g % of it shows ~p of ~w, of ~w'-[Percent, Face, Word, Root] ].
pixel_statement_en(background_part(Percent, Colour)) -->
    [ '~4g % of it shows the background, ~p'-[Percent, Colour] ].
pixel_statement_en(seen_place(point(X,Y,Z))) -->
    [ 'in the middle of that part, at (~6g, ~6g, ~6g) of the model'-
      [X, Y, Z] ].
pixel_statement_en(placed_as(N)) -->
    { root(N, Word) },
    [ 'placed as ~w'-[Word] ].
pixel_statement_en(operand_of(I, Count, Operation, N, Away)) -->
    { of_node(Operation, N, Word) },
    [ 'operand ~d of ~d of ~w'-[I, Count, Word] ],
    (   { Away == taken_away }
    ->  [ ', which takes it away' ]
    ;   []
    ).
pixel_statement_en(inner_side) -->
    [ 'the line of sight leaves the leaf there: its inner side is seen' ].
pixel_statement_en(owner(By)) -->
    [ 'other faces lie in it: it is seen, ' ],
    chosen_by(By).
pixel_statement_en(not_owner(Face, Leaf, S, Name)) -->
    { leaf(Leaf, S, Name, Word) },
    [ 'not ~p of ~w'-[Face, Word] ].
pixel_statement_en(passed(Way, Face, Leaf, S, Name, Before)) -->
    { leaf(Leaf, S, Name, Word) },
    [ 'nearer by ~6g, the line of sight ~w ~w through ~p'-
      [Before, Way, Word, Face] ].
pixel_statement_en(outside_all(Operation, N, Count, R)) -->
    { of_node(Operation, N, Word), root(R, Root) },
    [ '~w is not there: it is outside all ~d operands of ~w'-
      [Root, Count, Word] ].
pixel_statement_en(taken_away(J, Operation, N, R)) -->
    { of_node(Operation, N, Word), root(R, Root) },
    [ '~w is not there: operand ~d of ~w takes it away'-[Root, J, Word] ].
pixel_statement_en(outside_leaf(Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~w is not there: it is outside ~w'-[Root, Word] ].
pixel_statement_en(lets_through(R)) -->
    { root(R, Root) },
    [ '~w is there, and light from behind comes through it'-[Root] ].
pixel_statement_en(let_through(R, By)) -->
    { root(R, Root) },
    [ '~w is there, but may_hide/2 (~w) lets what is behind it be seen'-
      [Root, By] ].
pixel_statement_en(cut_away(R)) -->
    { root(R, Root) },
    [ '~w is not there: a plane cuts it away'-[Root] ].
pixel_statement_en(see_through(A)) -->
    [ 'it is see-through: ~4g of the light is its own'-[A] ].
pixel_statement_en(shine(F, N, Added)) -->
    [ 'its shine(~w, ~w) adds ~5g of white light'-[F, N, Added] ].
pixel_statement_en(hatched) -->
    [ 'as the face of a section it is hatched: a quarter of it is dark' ].
pixel_statement_en(hidden_face(Face, Leaf, S, Name, R, Behind)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ 'it hides ~p of ~w, of ~w, ~6g behind it'-[Face, Word, Root, Behind] ].
pixel_statement_en(look_by_rule(Colour, By)) -->
    [ 'its colour is ~p, by surface_look/4 of ~w'-[Colour, By] ].
pixel_statement_en(look_of(N, Colour)) -->
    { root(N, Word) },
    [ 'its colour is ~p, the look of ~w: the nearest that has one'-
      [Colour, Word] ].
pixel_statement_en(look_of_palette(Colour, By)) -->
    [ 'its colour is ~p, of the palette by ~w: no look/2 says another one'-
      [Colour, By] ].
pixel_statement_en(dot_by_rule(By)) -->
    [ 'what it shows is the answer of pixel_colour/4 of ~w; where it has \c
       none, \c
       the sum of these parts'-[By] ].
pixel_statement_en(nearest_of_palette(Most)) -->
    [ 'it has the nearest of the ~d colours of its palette, at most'-[Most] ].
pixel_statement_en(normal(Right, Up, Towards)) -->
    [ 'it looks ~4g to the right, ~4g up and ~4g towards the eye'-
      [Right, Up, Towards] ].
pixel_statement_en(tone(Tone, By)) -->
    [ 'its tone is ~5g'-[Tone] ],
    by_rule('tone/3', By).
pixel_statement_en(light_from_everywhere(Strength)) -->
    [ '~5g from everywhere'-[Strength] ].
pixel_statement_en(light_from(Right, Up, Towards, Factor, Share)) -->
    [ '~5g from light from (~4g, ~4g, ~4g), right, up and towards the eye, \c
       of ~4g'-[Share, Right, Up, Towards, Factor] ].
pixel_statement_en(light_stopped(Percent, Face, Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~4g % of it is stopped by ~p of ~w, of ~w'-
      [Percent, Face, Word, Root] ].
pixel_statement_en(ramp(Shade, By, Bytes)) -->
    { bytes_word(Bytes, Word) },
    [ 'in that tone it is ~w, by the shade ~p'-[Word, Shade] ],
    by_rule('ramp/3', By).
pixel_statement_en(not_in_picture(S, Kind)) -->
    { segment_word(S, Word) },
    (   { Kind == solid }
    ->  [ 'segment ~d~w belongs to nothing that the picture shows'-[S, Word] ]
    ;   [ 'segment ~d~w is a ~w, and only solids and surfaces are \c
          shaded'-[S, Word, Kind] ]
    ).
pixel_statement_en(seen_after_all(S, Dots, X, Y)) -->
    { segment_word(S, Word) },
    [ 'segment ~d~w is seen, in about ~d dots: pixel(~d, ~d) is one'-
      [S, Word, Dots, X, Y] ].
pixel_statement_en(unseen(S)) -->
    { segment_word(S, Word) },
    [ 'nothing of segment ~d~w is seen'-[S, Word] ].
pixel_statement_en(unseen_where(Count, X, Y)) -->
    [ 'places of it that were asked: ~d, such as pixel(~d, ~d)'-[Count, X, Y] ].
pixel_statement_en(hidden_by_leaf(Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~w, of ~w, hides it'-[Word, Root] ].
pixel_statement_en(owned_by_face(Face, Leaf, S, Name, R, By)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~p of ~w, of ~w, lies in it and is seen, '-[Face, Word, Root] ],
    chosen_by(By).
pixel_statement_en(buried_in(R)) -->
    { root(R, Root) },
    [ 'it is inside ~w, before and behind that face'-[Root] ].
pixel_statement_en(back_side(R)) -->
    { root(R, Root) },
    [ 'it is the back of ~w, which ends there'-[Root] ].
pixel_statement_en(thinner_than_a_dot) -->
    [ 'it is nearest there, but thinner than the picture can show' ].
pixel_statement_en(out_of_the_picture) -->
    [ 'it has no face inside the frame of the picture' ].

%!  pixel_nothing_en(+Item)// is det.
%
%   What is said where the picture has no such dot, or the model no such
%   segment.

pixel_nothing_en(Item) -->
    [ 'there is nothing to explain in ~p'-[Item], nl,
      '  pixel(X, Y) is dot X of row Y of the picture that render makes with \c
       the same options, whole numbers from 0; why_not(seen(S)) asks of a \c
       segment S of the model.' ].

leaf(Leaf, 0, Name, Word) :-
    !,
    format(atom(Word), 'leaf ~d (~w)', [Leaf, Name]).
leaf(Leaf, S, Name, Word) :-
    format(atom(Word), 'leaf ~d (~w, segment ~d)', [Leaf, Name, S]).

root(R, Word) :-
    segment_word(R, Own),
    format(atom(Word), 'segment ~d~w', [R, Own]).

of_node(Operation, 0, Word) :-
    !,
    format(atom(Word), 'an operation ~w', [Operation]).
of_node(Operation, N, Word) :-
    root(N, Own),
    format(atom(Word), 'the ~w ~w', [Operation, Own]).

%   chosen_by(By): by whom owner/3 is said.

chosen_by(default) -->
    !,
    [ 'the first by leaf' ].
chosen_by(By) -->
    [ 'by owner/3 of ~w'-[By] ].

by_rule(_, default) -->
    !.
by_rule(Decision, By) -->
    [ ', by ~w of ~w'-[Decision, By] ].
