namespace ErrorMatching.Mating;

/// <summary>Which circle represents measured points.</summary>
internal enum CircleMethod
{
    /// <summary>The circle with the least sum of squared distances from them (Gauss).</summary>
    LeastSquares,

    /// <summary>The largest circle with no point inside: what fits into a bore.</summary>
    Inscribed,

    /// <summary>The smallest circle with no point outside: what a boss fits into.</summary>
    Circumscribed,
}
