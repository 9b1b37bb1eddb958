namespace ErrorMatching.Cell;

/// <summary>The folder with a machine's programs, wherever it is. Names are plain file names and cannot lead out of the folder.</summary>
/// <remarks>Every operation throws a <see cref="TransportException"/> if it did not complete, or may not have. It may then be partly done,
/// or still complete later. Writing and renaming read back the result, because over a network one combined operation costs far less than
/// two. Several may be called at the same time. Disposing of the folder closes what a transport keeps open between two
/// operations.</remarks>
public interface IMachineFolder : IDisposable
{
    /// <summary>The machine's name.</summary>
    string Machine { get; }

    /// <summary>The names in the folder.</summary>
    Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation);

    /// <summary>The bytes of a file; null if it does not exist.</summary>
    /// <exception cref="TransportException">With <see cref="TransportError.TooLarge"/> if it has more than
    /// <paramref name="mostBytes"/>.</exception>
    Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation);

    /// <summary>Writes a file, replacing an existing one, and reads it back. Others may see an incomplete file.</summary>
    /// <returns>The bytes read back; the caller compares them with the bytes written.</returns>
    Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <summary>Renames a file, replacing an existing one, and reads it back under its new name.</summary>
    /// <returns>The bytes read back.</returns>
    /// <exception cref="TransportException">With <see cref="TransportError.CannotReplace"/> if the server does not rename over an existing
    /// file, or refuses this name for another reason.</exception>
    Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation);

    /// <summary>Renames a file over a program, keeps the previous program under a third name, and reads both. So a last-moment change is
    /// not lost but found there. The program's name belongs to one of the two at every instant; after an interruption, the third name holds
    /// one of them, complete.</summary>
    /// <param name="from">The file; it may already have the third name.</param>
    /// <param name="to">The program's name.</param>
    /// <param name="aside">The third name, which nothing else may have, and no other attempt. It is free afterward if the program's name
    /// was free before.</param>
    /// <param name="mostBytes">Maximum number of bytes to read.</param>
    /// <param name="cancellation">Cancels immediately.</param>
    /// <returns>Null if the transport does not support it; then nothing has changed.</returns>
    Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation);

    /// <summary>Deletes a file; succeeds if it does not exist.</summary>
    Task DeleteAsync(string name, CancellationToken cancellation);

    // Most transports keep nothing open.
    void IDisposable.Dispose() => GC.SuppressFinalize(this);
}

/// <summary>A program that replaced another, and the replaced one.</summary>
/// <param name="There">The bytes read back under the program's name.</param>
/// <param name="Was">The bytes that had the name until that moment, read after the replacement; null if there were none.</param>
public sealed record ReplacedProgram(byte[] There, byte[]? Was);
