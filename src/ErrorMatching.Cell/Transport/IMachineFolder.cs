namespace ErrorMatching.Cell;

/// <summary>The folder of a machine's programs, wherever it is. Names are plain file names; nothing leads out of the folder.</summary>
/// <remarks>Every operation throws a <see cref="TransportException"/> if it did not happen, or may not have; it may then have happened in part.</remarks>
public interface IMachineFolder
{
    /// <summary>Names of the files in the folder.</summary>
    Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation);

    /// <summary>The bytes of a file; null if there is none of this name.</summary>
    Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation);

    /// <summary>Writes a file, replacing one of this name. Seen from others it may appear in part.</summary>
    Task WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <summary>Renames a file over another.</summary>
    /// <exception cref="TransportException">With <see cref="TransportError.CannotReplace"/> if the server does not rename over an existing file.</exception>
    Task RenameAsync(string from, string to, CancellationToken cancellation);

    /// <summary>Deletes a file; none of this name is no error.</summary>
    Task DeleteAsync(string name, CancellationToken cancellation);
}
