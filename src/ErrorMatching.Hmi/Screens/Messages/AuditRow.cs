namespace ErrorMatching.Hmi;

/// <summary>A displayed entry of the audit trail.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Time">Its time.</param>
/// <param name="Who">Who acted.</param>
/// <param name="What">The act.</param>
/// <param name="Subject">What it applied to.</param>
/// <param name="Basis">Its basis.</param>
public sealed record AuditRow(string Number, string Time, string Who, string What, string Subject, string Basis)
{
    // About two lines of its column.
    private const int LongBasis = 100;

    /// <summary>The basis; if it is long, only its first sentence.</summary>
    public string Short =>
        Basis.Length > LongBasis && Sentence.First(Basis) is { } first && first.Length < Basis.Length ? first + " …" : Basis;
}
