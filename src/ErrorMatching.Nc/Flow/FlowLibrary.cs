namespace ErrorMatching.Nc;

/// <summary>The files of called programs that are not in the file itself, each searched once.</summary>
internal sealed class FlowLibrary(NcDialect dialect, FlowSettings settings)
{
    private readonly Dictionary<string, FlowIndex?> _files = new(StringComparer.Ordinal);

    /// <summary>The file of a program; null if there is none.</summary>
    public FlowIndex? Find(string name)
    {
        if (!_files.TryGetValue(name, out var index))
        {
            index = settings.Library(name) is { } program ? new FlowIndex(program, dialect) : null;
            _files.Add(name, index);
        }

        return index;
    }
}
