namespace ErrorMatching.Nc;

/// <summary>What a word itself says about how its value counts.</summary>
public enum WordDistance : byte
{
    /// <summary>Nothing: the modal G90 or G91 decides.</summary>
    Modal,

    /// <summary>A position: <c>X=AC(10)</c>.</summary>
    Absolute,

    /// <summary>An increment: <c>X=IC(10)</c>.</summary>
    Incremental,
}
