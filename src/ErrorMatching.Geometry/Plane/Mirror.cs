namespace ErrorMatching.Geometry;

/// <summary>What a transform mirrors before it rotates.</summary>
public enum Mirror
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>x becomes -x.</summary>
    X,

    /// <summary>y becomes -y.</summary>
    Y,
}
