namespace ErrorMatching.Hmi;

/// <summary>An entry of the audit trail, as it is shown.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Time">When.</param>
/// <param name="Who">Who.</param>
/// <param name="What">What was done.</param>
/// <param name="Subject">To what.</param>
/// <param name="Basis">On what basis.</param>
public sealed record AuditRow(string Number, string Time, string Who, string What, string Subject, string Basis)
{
    // About two lines of its column.
    private const int LongBasis = 100;

    /// <summary>The basis, of a long one its first sentence.</summary>
    public string Short => Basis.Length > LongBasis && Sentence.First(Basis) is { } first && first.Length < Basis.Length ? first + " …" : Basis;
}
