namespace ErrorMatching.Mating;

/// <summary>Why an uninterrupted cut is not the one that a boundary is sought by.</summary>
internal enum CutFault
{
    /// <summary>It is: it passes all key points at one distance, on one side, one behind the other.</summary>
    None,

    /// <summary>A key point lies at another distance.</summary>
    Apart,

    /// <summary>Cutter compensation is active at some key points and not at others.</summary>
    Compensation,

    /// <summary>Key points lie on both of its sides.</summary>
    Sides,

    /// <summary>It passes a key point twice.</summary>
    Twice,

    /// <summary>It does not pass the key points one behind the other, as they are named: in another order, or there and back.</summary>
    Order,
}
