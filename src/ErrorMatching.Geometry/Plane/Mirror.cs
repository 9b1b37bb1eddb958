namespace ErrorMatching.Geometry;

/// <summary>The reflection that a transform applies before its rotation.</summary>
public enum Mirror
{
    /// <summary>None.</summary>
    None,

    /// <summary>x becomes -x.</summary>
    X,

    /// <summary>y becomes -y.</summary>
    Y,
}
