namespace ErrorMatching.Mating;

/// <summary>Which circle stands for measured points.</summary>
public enum CircleMethod
{
    /// <summary>The one with the least sum of squared distances from them (Gauss).</summary>
    LeastSquares,

    /// <summary>The largest that none of them lies inside of: what fits into a bore.</summary>
    Inscribed,

    /// <summary>The smallest that none of them lies outside of: what a boss fits into.</summary>
    Circumscribed,
}
