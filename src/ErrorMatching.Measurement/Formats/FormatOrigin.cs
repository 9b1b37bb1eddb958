namespace ErrorMatching.Measurement;

/// <summary>Where the columns of a format come from.</summary>
internal enum FormatOrigin
{
    /// <summary>From a built-in format.</summary>
    Named,

    /// <summary>From a description of the shop, which is followed to the letter.</summary>
    Described,

    /// <summary>From the header of each file.</summary>
    Recognized,
}
