using ErrorMatching.Measurement;

namespace ErrorMatching.Jobs;

/// <summary>A measurement belongs to the other piece.</summary>
public sealed class WrongPieceException(string file, SourceSide expected)
    : Exception($"{file}: {Sentence(expected)}")
{
    /// <summary>The file as the user or the job named it.</summary>
    public string File => file;

    /// <summary>The message without the file.</summary>
    public string Problem => Sentence(expected);

    private static string Sentence(SourceSide expected) =>
        $"found a measurement of the {Word(expected == SourceSide.Part ? SourceSide.Counterpart : SourceSide.Part)} by the job's rules "
            + $"of recognition; expected one of the {Word(expected)}.";

    private static string Word(SourceSide side) => side == SourceSide.Part ? "part" : "counterpart";
}
