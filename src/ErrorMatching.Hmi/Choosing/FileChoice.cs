namespace ErrorMatching.Hmi;

/// <summary>What somebody is asked to choose: <c>await shell.ChooseAsync(new(FileChoiceKind.Open, "System.Program", [".nc"]))</c>.</summary>
/// <param name="Kind">What is chosen.</param>
/// <param name="TitleKey">Key of the text that says what for.</param>
/// <param name="Extensions">The endings that are shown, each with its dot, such as <c>.nc</c>; none for all files. The first one is given to a file to be written whose name has none.</param>
public sealed record FileChoice(FileChoiceKind Kind, string TitleKey, IReadOnlyList<string> Extensions)
{
    /// <summary>The folder or file to begin at; null for where something was chosen last.</summary>
    public string? Start { get; init; }

    /// <summary>Which file of the samples is meant, by its name: it stands in the field where the samples are shown first; null if there is none.</summary>
    public string? Sample { get; init; }
}
