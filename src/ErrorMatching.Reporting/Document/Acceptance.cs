namespace ErrorMatching.Reporting;

/// <summary>What became of a program whose verdict says not to cut it: somebody accepted the verdict, or the program is withheld.</summary>
/// <param name="Accepted">Code of the verdict that was accepted; null for none.</param>
/// <param name="Withheld">Code of the verdict because of which no program is written; null if it is written.</param>
public sealed record Acceptance(string? Accepted, string? Withheld)
{
    /// <summary>The word that accepts every verdict.</summary>
    public const string Any = "any";

    /// <summary>Nothing had to be accepted, or nobody was asked.</summary>
    public static Acceptance None { get; } = new(null, null);

    /// <summary>Obeys a verdict, unless it is accepted.</summary>
    /// <param name="code">Its code.</param>
    /// <param name="isToCut">True if it says to cut.</param>
    /// <param name="accepted">The codes that are accepted, or <see cref="Any"/>.</param>
    public static Acceptance Of(string code, bool isToCut, IReadOnlyCollection<string> accepted)
    {
        ArgumentNullException.ThrowIfNull(accepted);
        return isToCut ? None : accepted.Contains(code) || accepted.Contains(Any) ? new(code, null) : new(null, code);
    }

    /// <summary>True if no program is written.</summary>
    public bool IsWithheld => Withheld is not null;

    /// <summary>What became of the program and what to do, in a sentence; null if nothing had to be accepted.</summary>
    public string? Sentence => Withheld is { } code
        ? $"No program is written, because the verdict is {code}. To write it all the same, run this again with --accept {code}."
        : Accepted is { } accepted ? $"The program is written all the same: the verdict {accepted} was accepted." : null;

    /// <summary>Writes the members <c>accepted</c> and <c>withheld</c> into the open object.</summary>
    public void Write(ReportWriter json)
    {
        ArgumentNullException.ThrowIfNull(json);
        json.Text("accepted", Accepted);
        json.Optional("withheld", Withheld, code =>
        {
            json.Text("code", code);
            json.Text("sentence", Sentence);
        });
    }

    /// <summary>Reads what <see cref="Write"/> writes; older reports do not state it.</summary>
    /// <exception cref="Refusals.InputException">A member is wrong.</exception>
    public static Acceptance Read(ReportReader json)
    {
        ArgumentNullException.ThrowIfNull(json);
        return new(json.OptionalText("accepted"), json.OptionalObject("withheld")?.Text("code"));
    }
}
