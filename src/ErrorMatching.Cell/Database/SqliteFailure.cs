using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <summary>What failures of SQLite mean for a store, in a setter's terms. Source: sqlite.org/rescode.html.</summary>
internal static class SqliteFailure
{
    private const int NoRoomForIndex = 4874;
    private const int NoSuchContent = 787;

    /// <summary>Translates a failure.</summary>
    public static StoreException Of(string file, SqliteException failure) => failure.SqliteErrorCode switch
    {
        5
            or 6 => new(
                StoreError.Locked,
                $"The store {file} is held by another process for longer than {CellDatabase.Patience.TotalSeconds} s. Nothing was changed.",
                failure),
        10 when failure.SqliteExtendedErrorCode == NoRoomForIndex => Full(file, failure),
        8 => new(StoreError.ReadOnly, $"The store {file} cannot be written: its disk or file is read-only. Nothing was changed.", failure),
        10 => new(
            StoreError.Disk,
            $"The disk of the store {file} reports an error. Nothing was changed. Look at the system's log and copy the store to a good "
                + $"disk.",
            failure),
        11 or 26 => Damaged(file, failure.Message, failure),
        13 => Full(file, failure),
        14 => new(
            StoreError.Denied,
            $"The store {file} cannot be opened: {failure.Message} Look at who may write the file and its folder.",
            failure),
        19 when failure.SqliteExtendedErrorCode == NoSuchContent =>
            new(StoreError.Missing, $"A content that is named is not in the store {file}. Nothing was changed.", failure),
        _ => new(StoreError.Unknown, $"The store {file}: {failure.Message}", failure),
    };

    /// <summary>A page of the store is damaged.</summary>
    public static StoreException Damaged(string file, string found, Exception? cause) =>
        new(StoreError.Damaged, $"The store {file} is damaged: {found.Trim()} Restore the latest backup.", cause);

    private static StoreException Full(string file, Exception cause) => new(
        StoreError.Full,
        $"The disk of the store {file} is full. Nothing was changed. Make room, then repeat what failed; a running cell repeats it by "
            + $"itself.",
        cause);
}
