namespace ErrorMatching.Nc;

/// <summary>Whether a word itself marks its value as a position or an increment.</summary>
public enum WordDistance : byte
{
    /// <summary>Neither: the modal G90 or G91 decides.</summary>
    Modal,

    /// <summary>A position: <c>X=AC(10)</c>.</summary>
    Absolute,

    /// <summary>An increment: <c>X=IC(10)</c>.</summary>
    Incremental,
}
