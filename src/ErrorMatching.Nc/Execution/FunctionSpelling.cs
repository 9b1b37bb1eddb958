namespace ErrorMatching.Nc;

/// <summary>How a function is called and how many arguments it takes.</summary>
/// <param name="Name">Its upper-case ASCII name.</param>
/// <param name="Meaning">What it computes.</param>
/// <param name="Least">Fewest arguments.</param>
/// <param name="Most">Most arguments.</param>
internal sealed record FunctionSpelling(string Name, ExpressionFunction Meaning, int Least = 1, int Most = 1);
