using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>A gauge's folder. A finished file is moved aside, read, handed over for archiving, and only then removed: the store has its
/// content, and a second copy would fill the disk and might be taken for the original. A kill at any instant loses nothing; at worst the
/// same arrival is handed over again, with the same key.</summary>
/// <param name="gauge">The gauge, with a folder.</param>
/// <param name="clock">Measures how long a file has been at rest.</param>
internal sealed class FileSource(GaugeSettings gauge, TimeProvider clock) : IDisposable
{
    // Above this even the hash takes too long: some seconds per gigabyte.
    private const long MostHashed = 4_000_000_000;
    private const int Attempts = 3;

    private const string NotRemoved = "it is archived and cannot be removed: some program still has it open.";
    private const string NotMoved =
        $"it is finished and cannot be moved aside: some program still has it open, this user must not move it, or {ClaimFolder.Name} "
            + $"has something else of its name. It is taken as soon as it can be.";

    private readonly string _folder = gauge.Incoming ?? throw new ArgumentException("The gauge has no folder.", nameof(gauge));
    private readonly FinishedFiles _finished = new(gauge, clock);
    private readonly ClaimFolder _claims = new(gauge.Incoming);
    private readonly FolderHint _hint = new(gauge.Incoming, clock);
    private readonly List<LeftFile> _held = [];
    private bool _mayHaveClaims = true;

    /// <summary>Files that match the gauge's pattern and that the last look left where they are.</summary>
    public IReadOnlyList<LeftFile> Left => [.. _finished.Left, .. _held];

    /// <summary>Takes the finished files, in order of modification time.</summary>
    /// <param name="archive">Stores an arrival permanently before it returns. If it throws, the file is left for the next look.</param>
    /// <param name="archiveUnread">Records a file that is too large to store, permanently before it returns. If it throws, the file is left
    /// for the next look.</param>
    /// <param name="cancellation">Checked between files.</param>
    /// <returns>How many were taken.</returns>
    /// <exception cref="SourceException">The folder cannot be read.</exception>
    /// <exception cref="OperationCanceledException">Canceled; files already handed over stay handed over.</exception>
    public int Take(Action<Arrival> archive, Action<UnreadArrival> archiveUnread, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(archive);
        ArgumentNullException.ThrowIfNull(archiveUnread);
        InFolder(_claims.Begin);
        try
        {
            return TakeHeld(archive, archiveUnread, cancellation);
        }
        finally
        {
            _claims.End();
        }
    }

    private int TakeHeld(Action<Arrival> archive, Action<UnreadArrival> archiveUnread, CancellationToken cancellation)
    {
        var taken = 0;
        _held.Clear();
        if (_mayHaveClaims)
        {
            foreach (var file in InFolder(Claimed))
            {
                taken += Pass(file) ? 1 : 0;
            }

            _mayHaveClaims = _held.Count > 0;
        }

        if (!InFolder(
            () => Directory.Exists(_folder) ? _hint.IsWorthALook() : throw new DirectoryNotFoundException("there is no such folder")))
        {
            return taken;
        }

        foreach (var file in InFolder(() => _finished.Of(new(_folder))))
        {
            cancellation.ThrowIfCancellationRequested();

            // Whatever happens from here on, the next look starts with the claimed files.
            var before = _mayHaveClaims;
            _mayHaveClaims = true;
            if (InFolder(() => Claim(file.Name)) is not { } claimed)
            {
                if (File.Exists(Path.Combine(_folder, file.Name)))
                {
                    Hold(file, NotMoved);
                }

                _hint.Forget();
                continue;
            }

            if (Pass(claimed))
            {
                taken++;
                _mayHaveClaims = before;
            }
        }

        if (_finished.IsWaiting)
        {
            _hint.Forget();
        }

        return taken;

        bool Pass(FileInfo file)
        {
            cancellation.ThrowIfCancellationRequested();
            return Hand(file, archive, archiveUnread, cancellation);
        }
    }

    /// <summary>Waits until another look may be worthwhile: until the system reports a change, but no longer than the gauge's polling
    /// interval.</summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public Task WaitAsync(CancellationToken cancellation) => _hint.WaitAsync(gauge.Every, cancellation);

    /// <summary>Stops listening for changes.</summary>
    public void Dispose() => _hint.Dispose();

    // Files that an earlier run, or another gauge of this folder, moved aside. A marker that is here alone shows that its file is finished.
    private List<FileInfo> Claimed()
    {
        var files = _claims.Files();
        if (gauge.Finished is FinishedByMarker { Suffix: var suffix })
        {
            var names = files.Select(f => f.Name).ToHashSet(StringComparer.Ordinal);
            foreach (var marker in names.Where(
                n => n.EndsWith(suffix, StringComparison.Ordinal)
                    && _finished.IsOurs(n[..^suffix.Length])
                    && !names.Contains(n[..^suffix.Length])))
            {
                var name = marker[..^suffix.Length];
                if (!File.Exists(Path.Combine(_folder, name)))
                {
                    // The file was withdrawn.
                    _claims.Remove(marker);
                }
                else if (_claims.Claim(name) is null)
                {
                    // The marker stays: it is the only sign that the file is finished.
                    Hold(new(Path.Combine(_folder, name)), NotMoved);
                }
            }

            files = _claims.Files();
        }

        // Values are moved here first and removed first: a description alone belongs to values that are stored already.
        var here = files.Select(f => f.Name).ToHashSet(StringComparer.Ordinal);
        foreach (var name in here.Where(
            n => MeasurementBytes.IsDescription(n) && !here.Contains(n[..^1] + 'x') && !here.Contains(n[..^1] + 'X')))
        {
            _claims.Remove(name);
        }

        return [.. files.Where(f => _finished.IsOurs(f.Name))];
    }

    // The marker first: from then on, nothing written under the file's name counts as finished. While another file of this name is still
    // claimed, the marker would be taken for that file's.
    private FileInfo? Claim(string name) =>
        gauge.Finished is FinishedByMarker marker && (_claims.Has(name) || _claims.Claim(name + marker.Suffix) is null)
            ? null
            : _claims.Claim(name);

    private bool Hand(FileInfo file, Action<Arrival> archive, Action<UnreadArrival> archiveUnread, CancellationToken cancellation)
    {
        if (PlainFile.Defect(file) is { } defect)
        {
            return Hold(file, $"{defect}, and only plain files are taken. Remove it from {ClaimFolder.Name}.");
        }

        var description = Description(file.Name);
        if (description is null && MeasurementBytes.DescriptionsOf(file.Name).Count > 0)
        {
            return Hold(file, FinishedFiles.Undescribed(file.Name));
        }

        for (var attempt = 0; attempt < Attempts; attempt++)
        {
            file.Refresh();
            description?.Refresh();
            if (!file.Exists || description?.Exists == false)
            {
                return false;
            }

            var (length, changed) = (file.Length + (description?.Length ?? 0), file.LastWriteTimeUtc.Ticks);
            if (length > gauge.MostBytes)
            {
                if (length > MostHashed)
                {
                    return Hold(file, "it is so large that it is not even hashed. Remove it from " + ClaimFolder.Name + ".");
                }

                if (FileReading.Hash(file, cancellation) is { } hash)
                {
                    archiveUnread(new(
                        gauge.Name,
                        ShownName.Of(file.Name),
                        ArrivalKey.Of(gauge.Name, file.Name, changed, hash),
                        hash,
                        length,
                        RecognitionResult.TooLarge,
                        Reason(length)));
                    if (!RemoveMarker(file.Name))
                    {
                        return Hold(file, NotRemoved);
                    }

                    InFolder(() => _claims.LayAside(file, hash));
                    if (description is not null && FileReading.Hash(description, cancellation) is { } described)
                    {
                        InFolder(() => _claims.LayAside(description, described));
                    }

                    return true;
                }
            }
            else if (Whole(file, description) is { } bytes)
            {
                var sha256 = ContentHash.Sha256(bytes);
                archive(new(gauge.Name, ShownName.Of(file.Name), ArrivalKey.Of(gauge.Name, file.Name, changed, sha256), bytes));
                return RemoveMarker(file.Name) && _claims.Remove(file.Name) && RemoveDescription(description)
                    ? true
                    : Hold(file, NotRemoved);
            }
        }

        return Hold(file, "it changes while it is read, or cannot be opened. It is read as soon as it can be.");
    }

    // The description of values, moved aside; null if there is none.
    private FileInfo? Description(string name) => MeasurementBytes.DescriptionsOf(name)
        .Select(d => _claims.Has(d) ? _claims.Files().First(f => f.Name == d)
            : File.Exists(Path.Combine(_folder, d)) ? _claims.Claim(d)
            : null)
        .FirstOrDefault(f => f is not null && PlainFile.Defect(f) is null);

    private static byte[]? Whole(FileInfo file, FileInfo? description) => FileReading.Whole(file) is not { } bytes ? null
        : description is null ? bytes
        : FileReading.Whole(description) is { } described ? MeasurementBytes.Joined(described, bytes)
        : null;

    private bool RemoveDescription(FileInfo? description) => description is null || _claims.Remove(description.Name);

    // Before the file: a marker that outlived it would make the next file of this name look finished.
    private bool RemoveMarker(string name) => gauge.Finished is not FinishedByMarker marker || _claims.Remove(name + marker.Suffix);

    private bool Hold(FileInfo file, string reason)
    {
        _held.Add(new(ShownName.Of(file.Name), reason));
        return false;
    }

    private Statement Reason(long length) => Recorded.TooLarge.With(length, gauge.Name, gauge.MostBytes, ClaimFolder.Name, _folder);

    private void InFolder(Action act) => InFolder(() =>
    {
        act();
        return true;
    });

    private T InFolder<T>(Func<T> look)
    {
        try
        {
            return look();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            _hint.Forget();
            throw new SourceException(
                $"The folder {_folder} of the gauge \"{gauge.Name}\" cannot be looked into: {e.Message.TrimEnd('.')}. Is it there, is "
                    + $"the share mounted, and may this user write to it?",
                e);
        }
    }
}

/// <summary>A gauge's folder cannot be read.</summary>
/// <param name="message">A sentence for a setter: gauge, folder, the error, what to do next.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
internal sealed class SourceException(string message, Exception? cause = null) : Exception(message, cause);
