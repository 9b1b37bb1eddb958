namespace ErrorMatching.Hmi;

/// <summary>A screen that accepts a code from a barcode scanner: the serial number of a piece, or a work order.</summary>
internal interface ITakesCodes
{
    /// <summary>Accepts a code.</summary>
    /// <param name="code">The scanned code without the final Enter; not empty.</param>
    void TakeCode(string code);
}
