:- module(sg_openscad_text,
          [ read_openscad/2             % +File, -Nodes
          ]).
:- use_module('../kernel', [csg_nodes/4]).
:- use_module('../limits', [limit_value/2, text_limits/1]).
:- use_module('../text_file', [with_text/4]).
/** <module> The text of an OpenSCAD .csg file.

That is what `openscad -o FILE.csg` writes: a tree of calls with their numbers
worked out, no variables, no loops.

    difference() {
        cube(size = [2, 2, 2], center = true);
        multmatrix([[1,0,0,0], [0,1,0,0], [0,0,1,5], [0,0,0,1]]) { ... }
    }

Here it becomes nodes; openscad.pl says what they mean:

    node(Modifiers, Name, Arguments, Children, Place)

Modifiers is a list of `*`, `%`, `#`, `!`; Arguments are Name-Value, the name a
number where the file gives none; values are numbers, the atoms true, false,
undef, inf and nan, string(Text), and lists. Place is
location(File, Line, Column), both from 1.

Errors are error(model_error(openscad(What)), Place), What one of

    expected(Wanted, Found)   Wanted: name, `(`, `)`, body, value, `,`, end
    open_string   open_comment   strange(Character)

and cannot_read(Why) as for model files.
*/

%!  read_openscad(+File, -Nodes) is det.
%
%   Nodes are those at the top level of File (`-`: standard input), in order.
%
%   @error model_error(openscad(What)), see above

read_openscad(File, Nodes) :-
    text_limits(Limits),
    with_text(csg, File, text(Name, _, Stream),
              csg_nodes(Stream, Name, Limits, Result)),
    (   Result = nodes(Nodes0)
    ->  Nodes = Nodes0
    ;   Result = fault(What, Line, Column),
        text_error(What, location(Name, Line, Column))
    ).

text_error(What, Place) :-
    (   limit_value(What, Most)
    ->  throw(error(model_error(limit(What, Most)), Place))
    ;   throw(error(model_error(openscad(What)), Place))
    ).
