namespace ErrorMatching.Hmi;

/// <summary>A request to choose a file: <c>await shell.ChooseAsync(new(FileChoiceKind.Open, "System.Program", [".nc"]))</c>.</summary>
/// <param name="Kind">What to choose.</param>
/// <param name="TitleKey">Key of the text that tells the purpose.</param>
/// <param name="Extensions">The extensions to show, each with its dot, such as <c>.nc</c>; empty for all files. A new file
/// without an extension gets the first one.</param>
public sealed record FileChoice(FileChoiceKind Kind, string TitleKey, IReadOnlyList<string> Extensions)
{
    /// <summary>The folder or file to start at; null for the last folder used.</summary>
    public string? Start { get; init; }

    /// <summary>Name of the sample file that fits. It is filled in if the samples' folder is shown first; null if there is none.</summary>
    public string? Sample { get; init; }

    /// <summary>Asks for the counterpart's program.</summary>
    /// <param name="sample">Name of the sample that fits.</param>
    public static FileChoice OfProgram(string sample) => new(
        FileChoiceKind.Open,
        "System.ChooseProgram",
        [".nc", ".ngc", ".mpf", ".spf", ".cnc", ".tap", ".min", ".prg", ".h", ".txt"])
    {
        Sample = sample,
    };
}

/// <summary>What to choose.</summary>
public enum FileChoiceKind
{
    /// <summary>An existing file to read.</summary>
    Open,

    /// <summary>A file to write. An existing one is replaced only after a second tap.</summary>
    Save,

    /// <summary>A folder to write to. It need not exist yet.</summary>
    Folder,
}
