:- module(sg_scan_line_file,
          [ scan_line_files/2,          % +Options, -Files
            scan_line_written/2         % +Scene, +File
          ]).
:- use_module('../drawing/drawing', [drawing_format/2, write_drawing/2]).
:- use_module('../drawing/scan_line_drawing', [scan_line_drawing/3]).
:- use_module('../output', [when_written/1]).
:- use_module('../shading/shading_scene', [scene_size/2]).
:- use_module('../stage', [stage/2]).
:- use_module(verb_output, [may_be_written/1, usage_error/1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(option), [option/3]).
/** <module> The option --scan-line of render: a line of the picture from above.
*/

%!  scan_line_files(+Options, -Files:list) is det.
%
%   Files are Y-File of each --scan-line.
%
%   @error usage_error(bad_value('--scan-line', Text, Form)),
%          usage_error(ending(File, Formats))

scan_line_files(Options, Files) :-
    option('scan-line'(Texts), Options, []),
    maplist(scan_line_file, Texts, Files).

scan_line_file(Text, Y-File) :-
    (   sub_atom(Text, Before, 1, _, =),
        sub_atom(Text, 0, Before, _, YText),
        atom_number(YText, Y0),
        number(Y0),
        Y0 >= 0
    ->  Y = Y0,
        After is Before+1,
        sub_atom(Text, After, _, 0, File),
        drawing_ending(File),
        may_be_written(File)
    ;   usage_error(bad_value('--scan-line', Text, 'Y=FILE (Y >= 0)'))
    ).

drawing_ending(File) :-
    findall(Format, drawing_format(Format, _), Formats),
    file_name_extension(_, Ending, File),
    (   downcase_atom(Ending, Format),
        memberchk(Format, Formats)
    ->  true
    ;   usage_error(ending(File, Formats))
    ).

%!  scan_line_written(+Scene, +File) is det.
%
%   Writes the line Y of Scene, in dots from above, File being Y-Name.
%
%   @error usage_error(bad_value('--scan-line', Y, Form)): it is below the
%   picture

scan_line_written(Scene, Y-File) :-
    scene_size(Scene, _-Height),
    (   Y < Height
    ->  true
    ;   format(atom(Form), '0 <= Y < ~d', [Height]),
        usage_error(bad_value('--scan-line', Y, Form))
    ),
    scan_line_drawing(Scene, Y, Drawing),
    stage(write, write_drawing(File, [drawing(Drawing)])),
    when_written(print_message(informational, sanggwan(wrote(File)))).
