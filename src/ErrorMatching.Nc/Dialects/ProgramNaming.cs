namespace ErrorMatching.Nc;

/// <summary>By what a control names the programs that it has.</summary>
public enum ProgramNaming : byte
{
    /// <summary>By what is at a program's head (<c>O0100</c>), under whatever name its file was sent.</summary>
    ByHead,

    /// <summary>By the program's file alone.</summary>
    ByFile,

    /// <summary>By the program's file, and the head has the same name (<c>%_N_P100_MPF</c>, <c>BEGIN PGM P100</c>).</summary>
    ByBoth,
}
