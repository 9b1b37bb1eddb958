namespace ErrorMatching.Jobs;

/// <summary>The piece to be cut, and its program, as it is being typed. What is empty is the job's default.</summary>
/// <param name="Program">File of the program, relative to the job.</param>
/// <param name="Dialect">The control: a built-in dialect, or a file of the shop.</param>
/// <param name="ToolDiameter">Diameter of the tool, mm.</param>
/// <param name="Measured">File of a counterpart that was measured before.</param>
/// <param name="Mirror"><c>none</c>, <c>x</c> or <c>y</c>.</param>
/// <param name="Rotate">Rotation from the part's frame to the program's, degrees.</param>
/// <param name="TranslateX">Translation along X behind it, mm.</param>
/// <param name="TranslateY">Translation along Y behind it, mm.</param>
/// <param name="Map">How far a key point may lie from the path of its blocks, mm.</param>
/// <param name="BlockSkip">How the switch for block skip stands: <c>off</c>, <c>on</c>, or empty.</param>
public sealed record CounterpartDraft(
    string Program = "",
    string Dialect = "",
    string ToolDiameter = "",
    string Measured = "",
    string Mirror = "none",
    string Rotate = "",
    string TranslateX = "",
    string TranslateY = "",
    string Map = "",
    string BlockSkip = "");
