namespace ErrorMatching.Cell;

/// <summary>A folder of one transfer that only this user may look into; gone when disposed.</summary>
internal sealed class PrivateFolder : IDisposable
{
    private readonly string _path = Directory.CreateTempSubdirectory("errormatch-").FullName;

    /// <summary>The path of a file in it.</summary>
    public string this[string name] => Path.Combine(_path, name);

    public void Dispose() => Directory.Delete(_path, recursive: true);
}
