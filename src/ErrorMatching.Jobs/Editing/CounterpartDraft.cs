using System.Text.Json.Serialization;
using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>The piece to be cut, and its program, as typed. An empty field means the job's default.</summary>
/// <param name="Program">Program file, relative to the job.</param>
/// <param name="Dialect">The control: a built-in dialect, or the shop's dialect file.</param>
/// <param name="ToolDiameter">Diameter of the tool, mm.</param>
/// <param name="Measured">File of an earlier measured counterpart.</param>
/// <param name="Mirror"><c>none</c>, <c>x</c> or <c>y</c>.</param>
/// <param name="Rotate">Rotation from the part's frame to the program's, degrees.</param>
/// <param name="TranslateX">Translation along X after the rotation, mm.</param>
/// <param name="TranslateY">Translation along Y after the rotation, mm.</param>
/// <param name="Map">Allowed distance of a key point from the path of its blocks, mm.</param>
/// <param name="BlockSkip">State of the block skip switch: <c>off</c>, <c>on</c>, or empty.</param>
/// <param name="Libraries">Folders with called programs, relative to the job, with semicolons between them.</param>
/// <param name="Assume">Values of variables that only the machine knows, as <c>#100=1</c> with semicolons between them.</param>
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
    string BlockSkip = "",
    string Libraries = "",
    string Assume = "")
{
    /// <summary>SHA-256 of the program for which the blocks were chosen; empty if the job does not state it.</summary>
    public string ProgramSha256 { get; init; } = "";

    /// <summary>The individual folders of <see cref="Libraries"/>.</summary>
    [JsonIgnore]
    public IReadOnlyList<string> LibraryList =>
        Libraries.Split(';', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
}

/// <summary>A program imported into a draft.</summary>
public sealed record DraftProgram
{
    /// <summary>SHA-256 of its bytes as 64 lower-case hexadecimal digits.</summary>
    public required string Sha256 { get; init; }

    /// <summary>Its bytes.</summary>
    [JsonIgnore]
    public ReadOnlyMemory<byte> Bytes { get; init; }

    /// <summary>Creates it from the program's bytes.</summary>
    public static DraftProgram Of(ReadOnlyMemory<byte> bytes) =>
        new() { Sha256 = ContentHash.Sha256(bytes.Span), Bytes = bytes };
}
