:- module(sg_problem_en,
          [ problem_en//1               % +What
          ]).
/** <module> What is wrong with a file of problems, in English.

problem_ko.pl has the same heads in Korean (tests/rules/problem/).
*/

%!  problem_en(+What)// is det.
%
%   The message for model_error(problem(What)).

problem_en(fact(Name, Arity)) -->
    [ 'a file of problems has no facts ~w/~w'-[Name, Arity], nl,
      '  Write problem(Name, Model, Items), variant(Name, Parameter, Values), \c
       sheet(Paper, Names, Items)', nl,
      '  and pupils(Names).' ].
problem_en(variable) -->
    [ 'this has a variable: facts of problems are data', nl,
      '  Begin names with a small letter, or quote them.' ].
problem_en(item(Item)) -->
    [ '~p is no item here'-[Item], nl,
      '  A problem has given(Views), blank(View), branch(S), generators(N), \c
       planes(Axis), planes(Axis, N), edges(all),', nl,
      '  hide(penetration), show(penetration), \c
       ask(draw(penetration)), ask(draw(penetration, Views)),', nl,
      '  ask(count(loops)), ask(develop(S)), \c
       ask(measure(What, Unit, Tolerance)), \c
       part(S, Language, Text), text(Language, Text);', nl,
      '  a sheet angle(first), angle(third), title_block(Item, Text), \c
       title_block([class, name, number, date]).' ].
problem_en(model(Model)) -->
    [ '~p is no name of a model file'-[Model], nl,
      '  Write it in quotes: it lies beside the file of problems.' ].
problem_en(paper(Paper)) -->
    [ '~p is no paper'-[Paper], nl,
      '  Write A4 to A0 in quotes, such as \'A3\'.' ].
problem_en(values(Values)) -->
    [ '~p is no list of values of a parameter'-[Values], nl,
      '  Write variant(Name, Parameter, [20, 25, 30]), or 20..30, or \c
       between(20, 30, 2.5).' ].
problem_en(seed(Seed)) -->
    [ '~p is no seed'-[Seed], nl,
      '  Write variant(Name, Parameter in [20, 25, 30], seed(2026)): a whole \c
       number.' ].
problem_en(pupils(Names)) -->
    [ '~p is no list of pupils'-[Names], nl,
      '  Write pupils([\'Kim\', \'Lee\']): each name once.' ].
problem_en(twice(Name)) -->
    [ 'there are two problems ~p'-[Name], nl,
      '  Give one of them another name.' ].
problem_en(no_problem(Name)) -->
    [ 'there is no problem ~p'-[Name], nl,
      '  Names are those of problem(Name, Model, Items).' ].
problem_en(no_sheet(Name)) -->
    [ 'problem ~p stands on no sheet'-[Name], nl,
      '  Name it in sheet(Paper, Names, Items).' ].
problem_en(measure(Measure)) -->
    [ '~p is no measure'-[Measure], nl,
      '  Write shortest_generator(S), longest_generator(S), generator(S, I), \c
       edge(S, V, W), angle(S, U, V, W), area(S),', nl,
      '  perimeter(S), sector(S), volume(S) or coordinate(I, x): of segment \c
       S, of its vertices, of point I.' ].
problem_en(unit(Measure, Unit, Units)) -->
    { atomic_list_concat(Units, ', ', Text) },
    [ '~p is not measured in ~p'-[Measure, Unit], nl,
      '  Units of it are: ~w.'-[Text] ].
problem_en(tolerance(Measure, Tolerance)) -->
    [ 'how far may an answer to ~p be off? ~p is no tolerance'-
      [Measure, Tolerance], nl,
      '  Write a number above 0, in the unit, such as 0.1.' ].
problem_en(all_blank) -->
    [ 'all views are blank, so nothing is given', nl,
      '  Name another view in given(Views).' ].
problem_en(no_view(Measure, Names)) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ 'no view shows which point ~p is, without telling the answer'-[Measure],
      nl,
      '  Give one of these views, not blank: ~w.'-[Text] ].
problem_en(no_segment(S)) -->
    [ 'the model has no segment ~p'-[S], nl,
      '  Segments are those of segment(S, Kind, Term) that are operands of \c
       none.' ].
problem_en(no_pattern(S)) -->
    [ 'segment ~p is a curve: it has no pattern'-[S], nl,
      '  Name a solid or a surface in ask(develop(S)).' ].
problem_en(no_vertex(S, V)) -->
    [ 'segment ~p has no vertex ~p'-[S, V], nl,
      '  sanggwan query MODEL "v(~w, V, X, Y, Z)" lists its vertices.'-[S] ].
problem_en(no_measure(Measure)) -->
    [ '~p has no value in this model'-[Measure], nl,
      '  Generators are of cylinders and cones and have a free end, sectors \c
       of right circular cones, volumes of solids whose', nl,
      '  surfaces are known, coordinates of points on the penetration line.' ].
problem_en(too_fine(Measure, Tolerance)) -->
    [ '~p is not known as exactly as ~p'-[Measure, Tolerance], nl,
      '  Give a larger tolerance.' ].
problem_en(not_given(Name, Names)) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ 'the line is to be drawn in view ~p, which the problem does not have'-
      [Name], nl,
      '  Its views are those of given(Views) and blank(View): ~w.'-[Text] ].
problem_en(shown_and_asked) -->
    [ 'the question shows the penetration line, so it can be neither hidden \c
       nor asked for', nl,
      '  Leave out show(penetration), or ask(draw(...)) and \c
       hide(penetration).' ].
