namespace ErrorMatching.Cell;

/// <summary>A slot's program may not be replaced without asking a person. It is unchanged.</summary>
/// <param name="found">What the machine holds; null if nothing.</param>
/// <param name="message">A sentence for a setter.</param>
public sealed class ChangedAtMachineException(byte[]? found, string message) : Exception(message)
{
    /// <summary>What the machine holds; null if nothing.</summary>
    public byte[]? Found => found;
}
