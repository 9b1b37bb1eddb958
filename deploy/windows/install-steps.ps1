# What install.ps1 and uninstall.ps1 share. For Windows PowerShell 5.1 and later. The steps with files run on any system; those with the
# registry, the Start menu and PATH need Windows.

$ErrorActionPreference = 'Stop'
Set-StrictMode -Version 3

# What was installed is written into this file of the target folder. Only what it lists is ever replaced or removed.
$ManifestName = 'installed.json'

# The files of an archive, as deploy/pack lists them.
$SumsName = 'SHA256SUMS'

# A file is copied to a name with this at its end and then renamed: a listed file is whole, or it is not there.
$PartSuffix = '.installing'

$Products = @{
    station = @{
        Title = 'ErrorMatching station'; Program = 'errormatch-station.exe'; Folder = 'Station'; Key = 'ErrorMatching.Station'
    }
    console = @{
        Title = 'ErrorMatching console and cell'; Program = 'errormatch.exe'; Folder = 'Console'; Key = 'ErrorMatching.Console'
    }
}

function Test-Windows { [Environment]::OSVersion.Platform -eq 'Win32NT' }

function Test-Administrator {
    $user = [Security.Principal.WindowsPrincipal][Security.Principal.WindowsIdentity]::GetCurrent()
    $user.IsInRole([Security.Principal.WindowsBuiltInRole]::Administrator)
}

# True for a link to somewhere else: a symbolic link, a junction or a mount point. What is behind one is never touched.
function Test-Link([string] $Path) {
    (Test-Path -LiteralPath $Path) -and (([IO.File]::GetAttributes($Path) -band [IO.FileAttributes]::ReparsePoint) -ne 0)
}

# A path below a folder, as it is written in the manifest: with slashes, and never one that leads out of the folder.
function Join-Below([string] $Folder, [string] $Relative) {
    if ($Relative -eq '' -or [IO.Path]::IsPathRooted($Relative) -or $Relative -match '[:\\]' -or $Relative -split '/' -contains '..') {
        throw "The list of installed files names '$Relative', which is not a file of the program. Nothing was changed."
    }
    Join-Path $Folder $Relative.Replace('/', [IO.Path]::DirectorySeparatorChar)
}

# True if a path below a folder goes through a link, or is one.
function Test-LinkBelow([string] $Folder, [string] $Relative) {
    $path = $Folder
    foreach ($part in $Relative -split '/') {
        $path = Join-Path $path $part
        if (Test-Link $path) { return $true }
    }
    $false
}

# All files below a folder, as relative paths. Links are named, but not followed.
function Get-FilesBelow([string] $Folder, [string] $Prefix = '') {
    foreach ($entry in (New-Object IO.DirectoryInfo $Folder).GetFileSystemInfos()) {
        $relative = $Prefix + $entry.Name
        $isLink = ($entry.Attributes -band [IO.FileAttributes]::ReparsePoint) -ne 0
        if ($entry -is [IO.DirectoryInfo] -and -not $isLink) { Get-FilesBelow $entry.FullName "$relative/" } else { $relative }
    }
}

function Get-Sum([string] $File) { (Get-FileHash -LiteralPath $File -Algorithm SHA256).Hash.ToLowerInvariant() }

# True if a file has one of the sums, which are separated by blanks.
function Test-Sum([string] $File, [string] $Sums) { ($Sums -split ' ') -contains (Get-Sum $File) }

# The files of an unpacked archive with their sums, from the list that deploy/pack wrote into it. Anything else in the folder is not ours.
function Read-Sums([string] $Source) {
    $sums = @{}
    foreach ($line in [IO.File]::ReadAllLines((Join-Path $Source $SumsName))) {
        if ($line -notmatch '^([0-9a-f]{64})  (.+)$') { throw "$SumsName of $Source is damaged. Unpack the archive again." }
        $sums[$Matches[2]] = $Matches[1]
    }
    $sums
}

# The manifest of a target folder, or null.
function Read-Manifest([string] $Target) {
    $file = Join-Path $Target $ManifestName
    if (-not (Test-Path -LiteralPath $file -PathType Leaf)) { return $null }
    $manifest = [IO.File]::ReadAllText($file) | ConvertFrom-Json
    if (-not $Products.ContainsKey([string] $manifest.product)) { throw "$file is not a list of installed files of ErrorMatching." }
    $manifest
}

function Write-Manifest([string] $Target, $Manifest) {
    $part = Join-Path $Target ($ManifestName + $PartSuffix)
    $file = Join-Path $Target $ManifestName
    [IO.File]::WriteAllText($part, (ConvertTo-Json $Manifest -Depth 5))
    # Replaced at once, also for a reader that comes in between.
    if ([IO.File]::Exists($file)) { [IO.File]::Replace($part, $file, [NullString]::Value) } else { [IO.File]::Move($part, $file) }
}

# The listed files with their sums.
function Get-Listed($Manifest) {
    $listed = @{}
    foreach ($file in $Manifest.files) { $listed[[string] $file.path] = [string] $file.sha256 }
    $listed
}

# Fails if the program runs: Windows does not replace it then, and half of it would be new.
function Assert-NotRunning([string] $Program) {
    if (-not (Test-Path -LiteralPath $Program -PathType Leaf)) { return }
    try { [IO.File]::Open($Program, 'Open', 'ReadWrite', 'None').Dispose() }
    catch { throw "$Program is in use, or you may not change it. Close the station, or stop the cell, and try again. Nothing was changed." }
}

# The services that start a program of a folder.
function Get-ServicesOf([string] $Target) {
    foreach ($service in Get-ChildItem -LiteralPath 'HKLM:\SYSTEM\CurrentControlSet\Services' -ErrorAction SilentlyContinue) {
        $image = [string] $service.GetValue('ImagePath')
        if ($image.TrimStart('"').StartsWith($Target.TrimEnd('\') + '\', 'OrdinalIgnoreCase')) { $service.PSChildName }
    }
}

# Removes the listed files that are as they were installed, then folders that are empty. Returns what is left of them, with the reason.
function Remove-Listed([string] $Target, $Listed) {
    foreach ($relative in $Listed.Keys | Sort-Object) {
        $file = Join-Below $Target $relative
        if (Test-LinkBelow $Target $relative) { "$relative (a link)"; continue }
        if (Test-Path -LiteralPath "$file$PartSuffix" -PathType Leaf) { [IO.File]::Delete("$file$PartSuffix") }
        if (-not (Test-Path -LiteralPath $file -PathType Leaf)) { continue }
        if (-not (Test-Sum $file $Listed[$relative])) { "$relative (changed after it was installed)"; continue }
        [IO.File]::SetAttributes($file, 'Normal')
        [IO.File]::Delete($file)
    }
    $folders = foreach ($relative in $Listed.Keys) {
        $parts = $relative -split '/'
        for ($i = 1; $i -lt $parts.Count; $i++) { $parts[0..($i - 1)] -join '/' }
    }
    foreach ($relative in $folders | Sort-Object -Unique | Sort-Object Length -Descending) {
        $folder = Join-Below $Target $relative
        if ((Test-LinkBelow $Target $relative) -or -not (Test-Path -LiteralPath $folder -PathType Container)) { continue }
        if (@([IO.Directory]::GetFileSystemEntries($folder)).Count -eq 0) { [IO.Directory]::Delete($folder) }
    }
}

# A list of folders as in PATH, with one more, or without it. An entry counts as the folder in any spelling that Windows takes for it.
function Add-Entry([string] $Entries, [string] $Folder) {
    if ((Remove-Entry $Entries $Folder) -ne $Entries) { return $Entries }
    if ($Entries -eq '') { $Folder } else { $Entries.TrimEnd(';') + ';' + $Folder }
}

function Remove-Entry([string] $Entries, [string] $Folder) {
    @($Entries -split ';' | Where-Object { $_.Trim('"').TrimEnd('\') -ne $Folder.TrimEnd('\') }) -join ';'
}

# Changes PATH as it is stored, with its variables not replaced: [Environment]::SetEnvironmentVariable would write them out for good.
function Edit-Path([bool] $IsForAll, [scriptblock] $Edit) {
    $hive = if ($IsForAll) { [Microsoft.Win32.Registry]::LocalMachine } else { [Microsoft.Win32.Registry]::CurrentUser }
    $name = if ($IsForAll) { 'SYSTEM\CurrentControlSet\Control\Session Manager\Environment' } else { 'Environment' }
    $key = $hive.CreateSubKey($name)
    try {
        $before = [string] $key.GetValue('Path', '', 'DoNotExpandEnvironmentNames')
        $after = [string] (& $Edit $before)
        if ($after -ceq $before) { return }
        $kind = if ($key.GetValueNames() -contains 'Path') { $key.GetValueKind('Path') } else { 'ExpandString' }
        $key.SetValue('Path', $after, $kind)
    }
    finally { $key.Dispose() }
    # Removing a variable that does not exist changes nothing, and tells running programs that variables have changed.
    [Environment]::SetEnvironmentVariable('ERRORMATCH_INSTALLED', $null, 'User')
}

function Get-Hive([bool] $IsForAll) { if ($IsForAll) { 'HKLM:' } else { 'HKCU:' } }
function Get-OpenWithKey([bool] $IsForAll, $Product) { "$(Get-Hive $IsForAll)\Software\Classes\Applications\$($Product.Program)" }
function Get-UninstallKey([bool] $IsForAll, $Product) {
    "$(Get-Hive $IsForAll)\Software\Microsoft\Windows\CurrentVersion\Uninstall\$($Product.Key)"
}

# One value of a key, or null.
function Get-Value([string] $Key, [string] $Name) {
    if (Test-Path -LiteralPath $Key) { (Get-Item -LiteralPath $Key).GetValue($Name) }
}

function Set-Values([string] $Key, [hashtable] $Values) {
    if (-not (Test-Path -LiteralPath $Key)) { New-Item -Path $Key -Force | Out-Null }
    foreach ($name in $Values.Keys) {
        $kind = if ($Values[$name] -is [int]) { 'DWord' } else { 'String' }
        Set-ItemProperty -LiteralPath $Key -Name $name -Value $Values[$name] -Type $kind
    }
}

function Get-MenuFolder([bool] $IsForAll) {
    Join-Path ([Environment]::GetFolderPath($(if ($IsForAll) { 'CommonPrograms' } else { 'Programs' }))) 'ErrorMatching'
}

# Removes shortcuts of the Start menu that start the program, and the folder if nothing is left in it.
function Remove-Shortcuts([bool] $IsForAll, [string] $Program, [string[]] $Names) {
    $folder = Get-MenuFolder $IsForAll
    if ((Test-Link $folder) -or -not (Test-Path -LiteralPath $folder -PathType Container)) { return }
    $shell = New-Object -ComObject WScript.Shell
    foreach ($name in $Names) {
        $file = Join-Below $folder $name
        if (-not (Test-Path -LiteralPath $file -PathType Leaf)) { continue }
        # Another installation may have taken it over. Wine reads no shortcuts: there, the name has to suffice.
        if ('', $Program -contains [string] $shell.CreateShortcut($file).TargetPath) { [IO.File]::Delete($file) }
    }
    if (@([IO.Directory]::GetFileSystemEntries($folder)).Count -eq 0) { [IO.Directory]::Delete($folder) }
}
