namespace ErrorMatching.Mating;

/// <summary>Why an uninterrupted cut does not match a sought boundary.</summary>
internal enum CutFault
{
    /// <summary>It matches: it passes all key points at one distance, on one side, one after the other.</summary>
    None,

    /// <summary>A key point is at a different distance.</summary>
    Apart,

    /// <summary>Cutter compensation is active at some key points and not at others.</summary>
    Compensation,

    /// <summary>Key points are on both of its sides.</summary>
    Sides,

    /// <summary>It passes a key point twice.</summary>
    Twice,

    /// <summary>It passes the key points in another order than named, or there and back.</summary>
    Order,
}
