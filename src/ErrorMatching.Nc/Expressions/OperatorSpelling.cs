namespace ErrorMatching.Nc;

/// <summary>The spelling of an operator and its precedence.</summary>
/// <param name="Spelling">Its upper-case ASCII text.</param>
/// <param name="Meaning">What it computes.</param>
/// <param name="Rank">Operators of a higher rank are computed first.</param>
internal sealed record OperatorSpelling(string Spelling, ExpressionOperator Meaning, int Rank)
{
    public bool IsWord => char.IsAsciiLetter(Spelling[0]);
}
