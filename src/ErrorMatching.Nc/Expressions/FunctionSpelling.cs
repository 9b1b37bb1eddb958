namespace ErrorMatching.Nc;

/// <summary>The name of a function and its number of arguments.</summary>
/// <param name="Name">Its upper-case ASCII name.</param>
/// <param name="Meaning">What it computes.</param>
/// <param name="Least">Minimum number of arguments.</param>
/// <param name="Most">Maximum number of arguments.</param>
internal sealed record FunctionSpelling(string Name, ExpressionFunction Meaning, int Least = 1, int Most = 1);
