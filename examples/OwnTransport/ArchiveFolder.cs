using System.IO.Compression;
using ErrorMatching.Cell;

namespace OwnTransport;

/// <summary>A machine whose programs are in a ZIP archive, such as one that a control imports as a whole.</summary>
/// <remarks>
/// Each change writes a new archive and renames it over the old one, so the archive is whole at every instant. That is all
/// <see cref="ProgramSender"/> needs: it writes, reads back, compares and replaces.
/// </remarks>
internal sealed class ArchiveFolder(string machine, string archive) : IMachineFolder
{
    public string Machine => machine;

    public async Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) =>
        [.. (await LoadAsync(cancellation)).Keys.Order(StringComparer.Ordinal)];

    public async Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation) =>
        Bounded((await LoadAsync(cancellation)).GetValueOrDefault(name), mostBytes);

    public async Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        await ChangeAsync(files => files[name] = bytes.ToArray(), cancellation);
        return (await LoadAsync(cancellation))[name];
    }

    public async Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        await ChangeAsync(files => Move(files, from, to), cancellation);
        return Bounded((await LoadAsync(cancellation))[to], mostBytes)!;
    }

    public async Task<ReplacedProgram?> ReplaceAsync(
        string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        await ChangeAsync(
            files =>
            {
                if (files.ContainsKey(to)) Move(files, to, aside);
                Move(files, from, to);
            },
            cancellation);
        var files = await LoadAsync(cancellation);
        return new(Bounded(files[to], mostBytes)!, Bounded(files.GetValueOrDefault(aside), mostBytes));
    }

    public Task DeleteAsync(string name, CancellationToken cancellation) => ChangeAsync(files => files.Remove(name), cancellation);

    private void Move(Dictionary<string, byte[]> files, string from, string to)
    {
        if (!files.Remove(from, out var bytes)) throw new TransportException(TransportError.Unknown, $"{machine} has no {from}.");
        files[to] = bytes;
    }

    private byte[]? Bounded(byte[]? bytes, long mostBytes) => bytes?.LongLength > mostBytes
        ? throw new TransportException(TransportError.TooLarge, $"{machine}: the file has more than {mostBytes} bytes.")
        : bytes;

    private async Task ChangeAsync(Action<Dictionary<string, byte[]>> change, CancellationToken cancellation)
    {
        var files = await LoadAsync(cancellation);
        change(files);
        var next = archive + ".new";
        await using (var zip = new ZipArchive(File.Create(next), ZipArchiveMode.Create))
        {
            foreach (var (name, bytes) in files.OrderBy(f => f.Key, StringComparer.Ordinal))
            {
                await using var entry = await zip.CreateEntry(name).OpenAsync(cancellation);
                await entry.WriteAsync(bytes, cancellation);
            }
        }

        File.Move(next, archive, overwrite: true);
    }

    private async Task<Dictionary<string, byte[]>> LoadAsync(CancellationToken cancellation)
    {
        var files = new Dictionary<string, byte[]>(StringComparer.Ordinal);
        if (!File.Exists(archive)) return files;
        await using var zip = await ZipFile.OpenReadAsync(archive, cancellation);
        foreach (var entry in zip.Entries)
        {
            using var bytes = new MemoryStream();
            await using var content = await entry.OpenAsync(cancellation);
            await content.CopyToAsync(bytes, cancellation);
            files[entry.FullName] = bytes.ToArray();
        }

        return files;
    }
}
