namespace ErrorMatching.Hmi;

/// <summary>A screen that knows what to do with a code from a barcode scanner: the serial number of a piece, or a work order.</summary>
public interface ITakesCodes
{
    /// <summary>Takes a code.</summary>
    /// <param name="code">What was scanned, without the Enter at its end; not empty.</param>
    void TakeCode(string code);
}
